// SPDX-License-Identifier: Apache-2.0
// A farm's queue and uploads for tests.
#pragma once

#include <chrono>
#include <string>

#include "host/queue/queue.hpp"

namespace farm_test {

// Of a spooler with this number.
queue::Queue open_farm(const std::string& address, const std::string& id,
                       std::chrono::milliseconds lease_time = std::chrono::seconds(15),
                       const std::string& boot = "boot");

// A job's file of a few bytes is in the database; the job is not yet.
queue::NewJob uploaded(const std::string& address, const std::string& name);

}  // namespace farm_test
