// SPDX-License-Identifier: Apache-2.0
// As the spooler does it.
#include "tests/farm/farm_queue.hpp"

#include <memory>

#include "host/queue/postgres_database.hpp"
#include "host/queue/shared_files.hpp"
#include "tests/temporary_folder.hpp"

namespace farm_test {

queue::Queue open_farm(const std::string& address, const std::string& id,
                       std::chrono::milliseconds lease_time, const std::string& boot) {
  return {std::make_unique<queue::PostgresDatabase>(address),
          {.id = id, .boot = boot, .place = "machine of " + id, .lease_time = lease_time}};
}

queue::NewJob uploaded(const std::string& address, const std::string& name) {
  const TemporaryFolder folder;
  folder.write(name + ".gcode", "G28 X\n");
  queue::SharedFiles(address).put(name + ".gcode", folder.path() / (name + ".gcode"));
  return {.name = name, .file = name + ".gcode", .bytes = 6};
}

}  // namespace farm_test
