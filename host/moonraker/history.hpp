// SPDX-License-Identifier: Apache-2.0
// Jobs of the past, as Moonraker lists them.
#pragma once

#include <string>

#include "host/moonraker/core.hpp"

namespace moonraker {

bool was_begun_on(const queue::Job& job, const std::string& printer);
// The filament of a job that did not finish is not known: 0.
Json history_item(Core& core, const queue::Job& job);

}  // namespace moonraker
