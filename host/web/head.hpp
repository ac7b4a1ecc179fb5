// SPDX-License-Identifier: Apache-2.0
// What a request says in its head, and what no head may say.
#pragma once

#include "host/web/guard.hpp"
#include "host/web/http.hpp"

namespace web {

// Its fault is that the head can be read in two ways, so that a proxy may understand another
// request: 400, or 417 for an unknown Expect.
RequestHead head_of(const httplib::Request& request);

}  // namespace web
