// SPDX-License-Identifier: Apache-2.0
// Reads S-expressions.
#include "tests/wiring/s_expression.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/files/file_text.hpp"

namespace wiring_files {
namespace {

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  Expression all() {
    const Expression expression = one();
    skip_space();
    if (at_ != text_.size()) throw std::runtime_error("more than one expression");
    return expression;
  }

 private:
  Expression one() {
    skip_space();
    if (next() == '(') {
      return list();
    }
    return {.word = next() == '"' ? quoted() : plain(), .list = {}};
  }
  Expression list() {
    Expression expression;
    ++at_;
    for (skip_space(); next() != ')'; skip_space()) {
      expression.list.push_back(one());
    }
    ++at_;
    return expression;
  }
  std::string quoted() {
    std::string word;
    for (++at_; next() != '"'; ++at_) {
      if (next() == '\\') ++at_;
      word += next();
    }
    ++at_;
    return word;
  }
  std::string plain() {
    const std::size_t end = text_.find_first_of(" \n()\"", at_);
    if (end == at_) throw std::runtime_error("a word is missing");
    std::string word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
  }
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  char next() const {
    if (at_ >= text_.size()) throw std::runtime_error("the expression does not end");
    return text_[at_];
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

const Expression* Expression::find(const std::string& name) const {
  const auto found = std::ranges::find_if(list, [&](const Expression& one) {
    return !one.list.empty() && one.list.front().word == name;
  });
  return found == list.end() ? nullptr : &*found;
}

std::string Expression::text(const std::string& name) const {
  const Expression* found = find(name);
  return found != nullptr && found->list.size() == 2 ? found->list[1].word : "";
}

Expression read_expression(const std::filesystem::path& file) {
  const std::string text = files::text_of(file);
  return Reader(text).all();
}

}  // namespace wiring_files
