// SPDX-License-Identifier: Apache-2.0
// Reads a page as strictly as a browser is lenient.
#pragma once

#include <string>
#include <string_view>

namespace tests {

// What is wrong with the elements of an HTML page with its SVG: an element that is not closed, or
// closed by another's tag, an attribute without quotes, a bare & or <, an id that occurs twice.
// Empty where nothing is.
std::string fault_in_page(std::string_view page);

// The text between the tags.
std::string text_without_tags(std::string_view html);

// What stands between the first `begin` and the next `end` after it; empty where they are not.
std::string between(std::string_view page, std::string_view begin, std::string_view end);

}  // namespace tests
