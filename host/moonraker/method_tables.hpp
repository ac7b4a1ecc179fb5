// SPDX-License-Identifier: Apache-2.0
// The methods, in groups: each row has a method's name, its form over HTTP, and what runs it.
#pragma once

#include <vector>

#include "host/moonraker/rpc.hpp"

namespace moonraker {

std::vector<Method> access_methods();  // access.*
std::vector<Method> database_methods();  // server.database.*
std::vector<Method> file_methods();  // server.files.*
std::vector<Method> history_methods();  // server.history.*
std::vector<Method> machine_methods();  // machine.*
std::vector<Method> object_methods();  // printer.objects.*
std::vector<Method> printer_methods();  // printer.*, apart from its objects
std::vector<Method> queue_methods();  // server.job_queue.*
std::vector<Method> server_methods();  // server.*, apart from the groups above

}  // namespace moonraker
