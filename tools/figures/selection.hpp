// SPDX-License-Identifier: Apache-2.0
// Selects one number from the output of a command.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace figures {

// A path leads from member to member: "/queue/underruns". In an array a part is an index, or names
// the one element whose members have these values, "/works/name=core/clocks" or
// "/rates/baud=250000&window=1/busy", or is "*" for all elements, also of an object. With "sum ",
// "max ", "min " or "count " in front of the path, all numbers found become one; without, there
// must be exactly one. A text that is a number is one. Throws std::runtime_error with the path.
double number_at(const nlohmann::json& json, const std::string& path);

// What the only group of a regular expression matches, as a number. Throws std::runtime_error where
// it matches nothing, or not the same number wherever it does.
double number_in(const std::string& text, const std::string& expression);

}  // namespace figures
