// SPDX-License-Identifier: Apache-2.0
// The jobs that wait for a printer, as Moonraker's job queue.
#pragma once

#include "host/moonraker/core.hpp"

namespace moonraker {

struct JobList {
  Json jobs = Json::array();
  std::string state;  // ready; or paused while the bed is not clear
};
JobList job_list(Core& core);

}  // namespace moonraker
