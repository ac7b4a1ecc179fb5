// SPDX-License-Identifier: Apache-2.0
// A job as JSON, as the API has it.
#pragma once

#include <nlohmann/json.hpp>

#include "host/queue/job.hpp"

namespace spooler {

nlohmann::json to_json(const queue::Job& job);

}  // namespace spooler
