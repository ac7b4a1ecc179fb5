// SPDX-License-Identifier: Apache-2.0
// Delimiters are looked for in what has come; only what may begin one is kept.
#include "host/web/multipart.hpp"

#include <algorithm>
#include <charconv>

#include "host/web/ascii.hpp"

namespace web {

namespace {

constexpr std::size_t longest_boundary = 200;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// What is between quotes; `text` begins behind the first one and then behind the second one. A
// backslash counts as such before all but a quote and another one: some clients send whole paths.
std::string quoted(std::string_view& text) {
  std::string value;
  while (!text.empty() && text.front() != '"') {
    const bool escapes =
        text.size() > 1 && text.front() == '\\' && (text[1] == '"' || text[1] == '\\');
    if (escapes) text.remove_prefix(1);
    value += text.front();
    text.remove_prefix(1);
  }
  if (text.empty()) throw MultipartError("a quoted text in a header has no end");
  text.remove_prefix(1);
  return value;
}

std::string value_of(std::string_view& text) {
  if (text.starts_with('"')) {
    text.remove_prefix(1);
    std::string value = quoted(text);
    text.remove_prefix(std::min(text.find(';'), text.size()));
    return value;
  }
  const std::size_t end = std::min(text.find(';'), text.size());
  std::string value(without_blanks(text.substr(0, end)));
  text.remove_prefix(end);
  return value;
}

// How many bytes at the end of `bytes` may begin the delimiter.
std::size_t begun_at_end(std::string_view bytes, std::string_view delimiter) {
  std::size_t length = std::min(bytes.size(), delimiter.size() - 1);
  while (!delimiter.starts_with(bytes.substr(bytes.size() - length))) --length;
  return length;
}

MultipartReader::Part part_of(std::string_view disposition) {
  if (!equal_names(without_blanks(disposition.substr(0, disposition.find(';'))), "form-data")) {
    throw MultipartError("a part of the form is no form-data");
  }
  const auto name = parameter_of(disposition, "name");
  if (!name) throw MultipartError("a part of the form has no name");
  MultipartReader::Part part{.name = *name, .file_name = parameter_of(disposition, "filename")};
  if (const auto extended = parameter_of(disposition, "filename*")) {
    if (auto text = decoded_text(*extended)) part.file_name = std::move(text);
  }
  return part;
}

}  // namespace

std::optional<std::string> parameter_of(std::string_view header, std::string_view name) {
  std::optional<std::string> found;
  header.remove_prefix(std::min(header.find(';'), header.size()));
  while (!header.empty()) {
    header.remove_prefix(1);  // the semicolon
    const std::size_t end = std::min(header.find_first_of("=;"), header.size());
    const std::string_view key = without_blanks(header.substr(0, end));
    header.remove_prefix(end);
    if (!header.starts_with('=')) continue;
    header.remove_prefix(1);
    while (!header.empty() && is_blank(header.front())) header.remove_prefix(1);
    std::string value = value_of(header);
    if (!equal_names(key, name)) continue;
    if (found) throw MultipartError("the parameter " + std::string(name) + " is there twice");
    found = std::move(value);
  }
  return found;
}

std::optional<std::string> boundary_of(std::string_view content_type) {
  auto boundary = parameter_of(content_type, "boundary");
  const auto is_printable = [](char c) { return c >= ' ' && c <= '~'; };
  if (!boundary || boundary->empty() || boundary->size() > longest_boundary ||
      !std::ranges::all_of(*boundary, is_printable)) {
    return std::nullopt;
  }
  return boundary;
}

std::optional<std::string> decoded_text(std::string_view extended_value) {
  const std::size_t first = extended_value.find('\'');
  if (!equal_names(extended_value.substr(0, first), "utf-8")) return std::nullopt;
  const std::size_t second = extended_value.find('\'', first + 1);
  if (second == std::string_view::npos) return std::nullopt;
  std::string text;
  for (std::size_t i = second + 1; i < extended_value.size(); ++i) {
    if (extended_value[i] != '%') {
      text += extended_value[i];
      continue;
    }
    unsigned char byte = 0;
    const std::string_view digits = extended_value.substr(i + 1, 2);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (error != std::errc{} || digits.size() != 2 || end != digits.data() + 2) return std::nullopt;
    text += static_cast<char>(byte);
    i += 2;
  }
  return text;
}

MultipartReader::MultipartReader(const std::string& boundary,
                                 std::function<void(const Part&)> begin,
                                 std::function<void(std::string_view)> data)
    : delimiter_("\r\n--" + boundary), begin_(std::move(begin)), data_(std::move(data)) {}

void MultipartReader::take(std::string_view bytes) {
  const bool is_joined = !rest_.empty();
  if (is_joined) rest_ += bytes;
  std::string joined = std::move(rest_);
  rest_.clear();
  std::string_view left = is_joined ? std::string_view(joined) : bytes;
  while (!left.empty()) {
    const std::size_t used = step(left);
    if (used == 0) break;
    left.remove_prefix(used);
  }
  rest_.assign(left);
}

// How many bytes are used; 0: more must come.
std::size_t MultipartReader::step(std::string_view bytes) {
  switch (state_) {
    case State::before:
    case State::body:
      return take_data(bytes);
    case State::after_delimiter:
      return take_delimiter_end(bytes);
    case State::head:
      return take_head(bytes);
    case State::end:
      skip(bytes.size());
      return bytes.size();
  }
  return bytes.size();
}

void MultipartReader::skip(std::size_t bytes) {
  skipped_ += bytes;
  if (skipped_ <= longest_head) return;
  throw MultipartError(is_whole() ? "too much follows the last delimiter of the form"
                                  : "the form has another boundary");
}

std::size_t MultipartReader::take_data(std::string_view bytes) {
  const std::size_t found = bytes.find(delimiter_);
  const bool ends = found != std::string_view::npos;
  const std::size_t size = ends ? found : bytes.size() - begun_at_end(bytes, delimiter_);
  if (state_ == State::body) {
    if (size > 0) data_(bytes.substr(0, size));
  } else {
    skip(size);
  }
  if (ends) state_ = State::after_delimiter;
  return ends ? size + delimiter_.size() : size;
}

std::size_t MultipartReader::take_delimiter_end(std::string_view bytes) {
  if (is_blank(bytes.front())) {
    std::size_t blanks = 0;
    while (blanks < bytes.size() && is_blank(bytes[blanks])) ++blanks;
    return blanks;
  }
  if (bytes.size() < 2) return 0;
  if (bytes.starts_with("--")) {
    state_ = State::end;
    skipped_ = 0;
  } else if (bytes.starts_with("\r\n")) {
    state_ = State::head;
  } else {
    throw MultipartError("a delimiter of the form is broken");
  }
  return 2;
}

std::size_t MultipartReader::take_head(std::string_view bytes) {
  constexpr std::string_view head_end = "\r\n\r\n";
  const std::size_t end = bytes.find(head_end);
  // The same in whatever pieces it comes.
  if (end == std::string_view::npos ? bytes.size() >= longest_head + head_end.size()
                                    : end > longest_head) {
    throw MultipartError("the head of a part is too long");
  }
  if (end == std::string_view::npos) return 0;
  std::optional<Part> part;
  for (std::size_t at = 0; at < end;) {
    const std::size_t line_end = bytes.find("\r\n", at);
    const std::string_view line = bytes.substr(at, line_end - at);
    at = line_end + 2;
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) throw MultipartError("a header of a part has no colon");
    if (!equal_names(without_blanks(line.substr(0, colon)), "content-disposition")) continue;
    if (part) throw MultipartError("a part of the form has two Content-Dispositions");
    part = part_of(line.substr(colon + 1));
  }
  if (!part) throw MultipartError("a part of the form has no Content-Disposition");
  state_ = State::body;
  begin_(*part);
  return end + head_end.size();
}

}  // namespace web
