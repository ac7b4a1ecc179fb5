// SPDX-License-Identifier: Apache-2.0
// A small parser of well-formed pages.
#include "tests/sim/page_reader.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <vector>

namespace tests {

namespace {

bool is_void(std::string_view name) {
  constexpr std::array<std::string_view, 5> names{"meta", "input", "br", "link", "img"};
  return std::ranges::find(names, name) != names.end();
}

std::string near(std::string_view page, std::size_t at) {
  return " at: " + std::string(page.substr(at, 80));
}

// ` name="value"` or ` name`, again and again.
std::string fault_in_attributes(const std::string& attributes, std::set<std::string>& ids) {
  static const std::regex attribute(R"re(\s+([-a-zA-Z:]+)(="([^"<]*)")?)re");
  std::size_t at = 0;
  for (std::sregex_iterator found(attributes.begin(), attributes.end(), attribute), end;
       found != end; ++found) {
    if (static_cast<std::size_t>(found->position()) != at) break;
    at += static_cast<std::size_t>(found->length());
    if ((*found)[1] == "id" && !ids.insert((*found)[3]).second) {
      return "id twice: " + (*found)[3].str();
    }
  }
  return attributes.find_first_not_of(" \n/", at) == std::string::npos
             ? ""
             : "attributes: " + attributes.substr(0, 80);
}

std::string fault_in_text(std::string_view text) {
  static const std::regex entity("&(amp|lt|gt|quot|nbsp|#[0-9]+);");
  for (std::size_t at = text.find('&'); at != std::string_view::npos; at = text.find('&', at + 1)) {
    const std::string rest(text.substr(at, 10));
    if (!std::regex_search(rest, entity, std::regex_constants::match_continuous)) {
      return "a bare & in: " + rest;
    }
  }
  return "";
}

}  // namespace

std::string fault_in_page(std::string_view page) {
  constexpr std::string_view doctype = "<!DOCTYPE html>\n";
  if (!page.starts_with(doctype)) return "no doctype";
  std::vector<std::string> open;
  std::set<std::string> ids;
  std::size_t at = doctype.size();
  while (at < page.size()) {
    const std::size_t tag = std::min(page.find('<', at), page.size());
    if (const std::string fault = fault_in_text(page.substr(at, tag - at)); !fault.empty()) {
      return fault;
    }
    if (tag == page.size()) break;
    const std::size_t end = page.find('>', tag);
    if (end == std::string_view::npos) return "a tag without end" + near(page, tag);
    const bool closing = page[tag + 1] == '/';
    const std::size_t name_at = tag + (closing ? 2 : 1);
    const std::size_t name_end = std::min(page.find_first_of(" \n/>", name_at), end);
    const std::string name(page.substr(name_at, name_end - name_at));
    if (name.empty() || !std::ranges::all_of(name, [](char c) { return std::isalnum(c) != 0; })) {
      return "a bare <" + near(page, tag);
    }
    at = end + 1;
    if (closing) {
      if (open.empty() || open.back() != name) {
        return "not open, or not innermost" + near(page, tag);
      }
      open.pop_back();
      continue;
    }
    const std::string attributes(page.substr(name_end, end - name_end));
    if (const std::string fault = fault_in_attributes(attributes, ids); !fault.empty()) {
      return fault;
    }
    if (name == "script" || name == "style") {
      at = page.find("</" + name + ">", at);  // their content has no tags
      if (at == std::string_view::npos) return name + " without end";
      at += name.size() + 3;
    } else if (!is_void(name) && page[end - 1] != '/') {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

std::string text_without_tags(std::string_view html) {
  std::string text;
  bool in_tag = false;
  for (const char character : html) {
    if (character == '<') {
      in_tag = true;
      text += ' ';
    } else if (character == '>') {
      in_tag = false;
    } else if (!in_tag) {
      text += character;
    }
  }
  return text;
}

std::string between(std::string_view page, std::string_view begin, std::string_view end) {
  const std::size_t from = page.find(begin);
  if (from == std::string_view::npos) return "";
  const std::size_t to = page.find(end, from + begin.size());
  return to == std::string_view::npos
             ? ""
             : std::string(page.substr(from + begin.size(), to - from - begin.size()));
}

}  // namespace tests
