// SPDX-License-Identifier: Apache-2.0
// What PrusaLink would answer, made of the spooler's state; names and states are its own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "host/queue/job.hpp"

namespace web::prusalink {

using Json = nlohmann::json;

// Of its one storage, which takes part in all paths of files.
inline constexpr const char* storage_name = "local";

Json storages(const std::filesystem::space_info& disk);
Json info(const std::string& printer);
// The answer to an upload.
Json uploaded(const std::string& name, std::int64_t bytes);

// Of one printer; `printer` and `job` of the spooler's snapshot, `job` null where none is printed.
Json status(const Json& printer, const Json& job);
Json job_of(const Json& printer, const Json& job);

}  // namespace web::prusalink
