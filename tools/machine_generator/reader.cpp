// SPDX-License-Identifier: Apache-2.0
// The typed and complete reading of a machine description's tables.
#include "machine_generator/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <system_error>

namespace machine_generator {

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 20;  // no machine needs a tenth of it

// The part before the comment; a # within quotes belongs to the text.
std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote == 0 && line[i] == '#') return line.substr(0, i);
    if (quote == '"' && line[i] == '\\') {
      ++i;
    } else if (quote == 0 && (line[i] == '"' || line[i] == '\'')) {
      quote = line[i];
    } else if (line[i] == quote) {
      quote = 0;
    }
  }
  return line;
}

// toml++ 3.4 has undefined behaviour for some characters beyond ASCII outside of texts and
// comments, and the firmware cannot say them to a host anyway. Texts of several lines, which
// nothing here needs, would make it hard to know what a comment is.
void check_characters(std::string_view text, const std::string& name) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = without_comment(text.substr(0, end));
    const auto fail = [&](std::string_view what) {
      throw DescriptionError(fmt::format("{}: line {}: {}", name, number, what));
    };
    if (std::ranges::any_of(line, [](char c) { return static_cast<unsigned char>(c) > 0x7e; })) {
      fail("holds a character outside ASCII, which only a comment may");
    }
    if (line.contains("\"\"\"") || line.contains("'''")) fail("begins a text of several lines");
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

toml::table Reader::parse(const std::filesystem::path& file) {
  const auto fail = [&](std::string_view what) {
    throw DescriptionError(fmt::format("{}: {}", file.string(), what));
  };
  std::error_code error;
  const bool exists = std::filesystem::exists(file, error);
  // Before it is opened: a named pipe would have to be waited for.
  if (exists && !std::filesystem::is_regular_file(file, error)) fail("is not a regular file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail("cannot be read");
  // Not by its size, which a file of /proc has only when it is read.
  std::string text(most_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) fail("cannot be read");
  if (text.size() > most_bytes) fail("is larger than 1 MiB");
  return parse(text, file);
}

toml::table Reader::parse(std::string_view text, const std::filesystem::path& name) {
  check_characters(text, name.string());
  try {
    return toml::parse(text, name.string());
  } catch (const toml::parse_error& error) {
    throw DescriptionError(fmt::format("{}: line {}: {}", name.string(), error.source().begin.line,
                                       error.description()));
  }
}

Reader::Reader(const std::filesystem::path& file, const toml::table& table, std::string place)
    : file_(file.string()), table_(table), place_(std::move(place)) {}

Reader Reader::table(const std::string& key) {
  const auto* table = node(key).as_table();
  if (table == nullptr) fail(key, "must be a table");
  return Reader(file_, *table, place_.empty() ? key : place_ + "." + key);
}

std::string Reader::text(const std::string& key) {
  const auto value = node(key).value<std::string>();
  if (!value || value->empty()) fail(key, "must be a text");
  return *value;
}

bool Reader::truth(const std::string& key) {
  const auto* boolean = node(key).as_boolean();
  if (boolean == nullptr) fail(key, "must be true or false");
  return boolean->get();
}

std::int64_t Reader::whole(const std::string& key, std::int64_t least, std::int64_t most) {
  const auto* integer = node(key).as_integer();
  if (integer == nullptr) fail(key, "must be a whole number");
  const std::int64_t value = integer->get();
  if (value < least || value > most) {
    fail(key, fmt::format("is {}, but must be {} to {}", value, least, most));
  }
  return value;
}

std::int64_t Reader::scaled(const std::string& key, std::int64_t scale, std::int64_t least,
                            std::int64_t most) {
  return scaled_value(key, node(key), scale, least, most);
}

std::vector<std::int64_t> Reader::scaled_list(const std::string& key, std::int64_t scale,
                                              std::int64_t least, std::int64_t most,
                                              std::size_t count) {
  const auto* list = node(key).as_array();
  if (list == nullptr || list->size() != count) {
    fail(key, fmt::format("must be a list of {} numbers", count));
  }
  std::vector<std::int64_t> values;
  for (const toml::node& value : *list) {
    values.push_back(scaled_value(key, value, scale, least, most));
  }
  return values;
}

std::int64_t Reader::scaled_value(const std::string& key, const toml::node& found,
                                  std::int64_t scale, std::int64_t least, std::int64_t most) const {
  if (!found.is_number()) fail(key, "must be a number");
  // value<double>() is empty for an integer that no double equals.
  const auto* integer = found.as_integer();
  const double value =
      integer != nullptr ? static_cast<double>(integer->get()) : found.as_floating_point()->get();
  const double product = value * static_cast<double>(scale);
  const auto bound = [scale](std::int64_t limit) {
    return static_cast<double>(limit) / static_cast<double>(scale);
  };
  // Written so that a NaN is out of bounds.
  if (!(product >= static_cast<double>(least) && product <= static_cast<double>(most))) {
    fail(key, fmt::format("is {}, but must be {} to {}", value, bound(least), bound(most)));
  }
  constexpr double tolerance = 1e-6;  // of the decimal number's binary form
  if (std::abs(product - std::round(product)) > tolerance) {
    fail(key, fmt::format("is {}, finer than the firmware's unit of 1/{}", value, scale));
  }
  return std::llround(product);
}

void Reader::finish() const {
  for (const auto& [key, value] : table_) {
    if (!used_.contains(std::string(key.str()))) {
      fail(std::string(key.str()), "is not an entry that this program knows");
    }
  }
}

void Reader::fail(const std::string& key, const std::string& what) const {
  const std::string full = place_.empty() ? key : place_ + "." + key;
  const toml::node* found = table_.get(key);
  const toml::source_region& place = found != nullptr ? found->source() : table_.source();
  throw DescriptionError(fmt::format("{}: line {}: {}: {}", file_, place.begin.line, full, what));
}

const toml::node& Reader::node(const std::string& key) {
  const toml::node* found = table_.get(key);
  if (found == nullptr) fail(key, "is missing");
  used_.insert(key);
  return *found;
}

}  // namespace machine_generator
