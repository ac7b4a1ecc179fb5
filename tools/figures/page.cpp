// SPDX-License-Identifier: Apache-2.0
// Line by line: code blocks stay, tables and marked numbers are made again.
#include "tools/figures/page.hpp"

#include <fmt/format.h>

#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tools/figures/expression.hpp"

namespace figures {

namespace {

class Writer {
 public:
  Writer(const Store& store, const Tables& tables, std::set<std::string>& used)
      : store_(store), tables_(tables), used_(used) {}

  Page page(const std::string& text) {
    std::istringstream stream(text);
    bool is_code = false;
    for (std::string line; std::getline(stream, line);) {
      ++number_;
      is_code ^= line.starts_with("```");
      if (is_code) {
        out(line);
      } else {
        read(line);
      }
    }
    if (table_) problem(fmt::format("the table {} has no end", table_->name));
    return page_;
  }

 private:
  struct OpenTable {
    std::string name;
    int line;
    std::string lines;
  };

  void read(const std::string& line) {
    static const std::regex begin(R"(<!-- figures: (\w+) -->)");
    std::smatch match;
    if (std::regex_match(line, match, begin)) {
      table_ = {.name = match[1], .line = number_, .lines = {}};
      out(line);
    } else if (table_ && line == "<!-- end -->") {
      close_table();
      out(line);
    } else if (table_) {
      table_->lines += line + "\n";
    } else {
      out(with_marked_numbers(line));
    }
  }

  std::string with_marked_numbers(const std::string& line) {
    static const std::regex marked(
        R"((-?(?:[0-9]{1,3}(?: [0-9]{3})+|[0-9]+)(?:\.[0-9]+)?)<!--([^>]*)-->)");
    std::string text;
    auto after = line.cbegin();
    for (std::sregex_iterator match(line.begin(), line.end(), marked), end; match != end; ++match) {
      text.append(after, (*match)[0].first);
      text += marked_number((*match)[1], (*match)[2]);
      after = (*match)[0].second;
    }
    return text.append(after, line.cend());
  }

  std::string marked_number(const std::string& old, const std::string& expression) {
    const auto number = value(expression);
    if (number && *number != old) {
      problem(fmt::format("{} stands for {}, which is {}", old, expression, *number));
    }
    return fmt::format("{}<!--{}-->", number.value_or(old), expression);
  }

  void close_table() {
    const auto table = tables_.find(table_->name);
    if (table == tables_.end()) {
      problem(fmt::format("there is no table {}", table_->name));
      page_.text += table_->lines;
    } else {
      used_.insert(table_->name);
      const std::string text = filled(table->second);
      if (text != table_->lines) {
        problem(fmt::format("the table {} shows other figures or words", table_->name));
      }
      page_.text += text;
    }
    table_.reset();
  }

  std::string filled(const std::string& table) {
    static const std::regex slot(R"(\{\{([^}]*)\}\})");
    std::string text;
    auto after = table.cbegin();
    for (std::sregex_iterator match(table.begin(), table.end(), slot), end; match != end; ++match) {
      text.append(after, (*match)[0].first);
      text += value((*match)[1]).value_or("?");
      after = (*match)[0].second;
    }
    return text.append(after, table.cend());
  }

  std::optional<std::string> value(const std::string& expression) {
    try {
      return shown(expression, store_, used_);
    } catch (const std::runtime_error& error) {
      problem(error.what());
      return std::nullopt;
    }
  }

  void out(const std::string& line) { page_.text += line + "\n"; }
  void problem(const std::string& what) {
    page_.problems.push_back(fmt::format("{}: {}", table_ ? table_->line : number_, what));
  }

  const Store& store_;
  const Tables& tables_;
  std::set<std::string>& used_;
  Page page_;
  std::optional<OpenTable> table_;
  int number_ = 0;
};

}  // namespace

Page with_figures(const std::string& text, const Store& store, const Tables& tables,
                  std::set<std::string>& used) {
  return Writer(store, tables, used).page(text);
}

}  // namespace figures
