// SPDX-License-Identifier: Apache-2.0
// The files of a printer: those of its jobs and of jobs for any printer, each name once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/moonraker/core.hpp"
#include "host/queue/job.hpp"

namespace moonraker {

inline constexpr const char* root = "gcodes";
// Of the root: no files are added, and none is removed but with its jobs.
inline constexpr const char* permissions = "rw";

// The latest job of each name.
std::map<std::string, queue::Job> files_of(Core& core);
// Throws Error 404. `name` may begin with the root's.
queue::Job file_named(Core& core, std::string name);

// As the list of a folder has it.
Json file_item(const queue::Job& job);
// As a notification and an answer to a change have it.
Json changed_item(const std::string& name, std::int64_t bytes, std::int64_t uploaded_ms);
// What the check has found, and what the slicer says in the file's head.
Json metadata(Core& core, const queue::Job& job);
// Gives all its jobs another name. Throws Error: 400 where no file here may have it, 403 where one
// has it.
Json move_file(Core& core, const std::string& source, const std::string& wanted);
// Ends and removes all its jobs. Throws Error 403 while one is printed.
Json remove_file(Core& core, const std::string& name);

}  // namespace moonraker
