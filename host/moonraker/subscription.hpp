// SPDX-License-Identifier: Apache-2.0
// Which fields of which printer objects a client wants, and which of them it has.
#pragma once

#include <nlohmann/json.hpp>

namespace moonraker {

using Json = nlohmann::json;

// `wanted`: for each object a list of fields, or null for all of them. What is not there is left
// out. Throws Error invalid_params where it has another form.
Json selected(const Json& objects, const Json& wanted);

// Fields of `now` that are not in `before`, or have another value there.
Json difference(const Json& now, const Json& before);

struct Subscription {
  Json wanted = Json::object();
  Json sent = Json::object();

  // Counts them as sent.
  Json changes_to(const Json& objects);
};

}  // namespace moonraker
