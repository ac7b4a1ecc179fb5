// SPDX-License-Identifier: Apache-2.0
// The figures in a Markdown page.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tools/figures/store.hpp"

namespace figures {

// Tables of figures by name: their text, with {{EXPRESSION}} for each number.
using Tables = std::map<std::string, std::string>;

struct Page {
  std::string text;  // with the figures as they are in the store
  std::vector<std::string> problems;  // "LINE: what is wrong"
};

// A number in front of <!--EXPRESSION--> is a figure, and so is all between a line
// "<!-- figures: TABLE -->" and a line "<!-- end -->". Nothing else changes. A figure that differs
// is a problem, and so is what cannot be read. `used` gets the names of figures and tables.
Page with_figures(const std::string& text, const Store& store, const Tables& tables,
                  std::set<std::string>& used);

}  // namespace figures
