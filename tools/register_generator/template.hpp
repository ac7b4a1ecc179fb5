// SPDX-License-Identifier: Apache-2.0
// Text templates: the generated file with @names@ as placeholders for values.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace register_generator {

using Values = std::map<std::string, std::string, std::less<>>;

// The template with each @name@ replaced by its value. A name that stands alone on its line takes a
// value of any number of lines, each indented as the name is; the line goes where the value is
// empty. Throws std::logic_error on a name without a value.
std::string fill(std::string_view text, const Values& values);

}  // namespace register_generator
