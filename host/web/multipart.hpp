// SPDX-License-Identifier: Apache-2.0
// A multipart/form-data body (RFC 7578), read as it comes and without a copy of what is in it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace web {

// The body is no such form; its text is for people.
struct MultipartError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The parameter of a header such as `form-data; name="file"`; of a quoted one what is in the
// quotes, with semicolons. Nothing where there is none. Throws MultipartError where it is there
// twice, or a quote is open.
std::optional<std::string> parameter_of(std::string_view header, std::string_view name);

// Of a Content-Type; nothing where it has none of 1 to 200 printable characters.
std::optional<std::string> boundary_of(std::string_view content_type);

// The text of `UTF-8''a%20b` (RFC 8187); nothing where it is no such text.
std::optional<std::string> decoded_text(std::string_view extended_value);

class MultipartReader {
 public:
  struct Part {
    std::string name;
    std::optional<std::string> file_name;  // as the client sends it: not cleaned
  };
  // Also of what is before the first part, and of what is behind the last one.
  static constexpr std::size_t longest_head = 8192;  // bytes, of a part

  // `data` belongs to the part that began last.
  MultipartReader(const std::string& boundary, std::function<void(const Part&)> begin,
                  std::function<void(std::string_view data)> data);

  // The next bytes of the body. Throws MultipartError, and what the functions throw; then it is not
  // to be called again.
  void take(std::string_view bytes);
  // The last delimiter has come.
  bool is_whole() const { return state_ == State::end; }

 private:
  enum class State : unsigned char { before, after_delimiter, head, body, end };

  std::size_t step(std::string_view bytes);
  void skip(std::size_t bytes);
  std::size_t take_data(std::string_view bytes);
  std::size_t take_delimiter_end(std::string_view bytes);
  std::size_t take_head(std::string_view bytes);

  std::string delimiter_;  // with the line end before it
  std::function<void(const Part&)> begin_;
  std::function<void(std::string_view)> data_;
  State state_ = State::before;
  std::string rest_ = "\r\n";  // that is not used yet; the first delimiter needs no line end
  std::size_t skipped_ = 0;  // before the first delimiter, or behind the last one
};

}  // namespace web
