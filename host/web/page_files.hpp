// SPDX-License-Identifier: Apache-2.0
// The page's files, as the build has embedded them.
#pragma once

#include <string_view>

namespace web {

extern const std::string_view page_html;
extern const std::string_view page_style;
extern const std::string_view page_script;
extern const std::string_view openapi;

}  // namespace web
