// SPDX-License-Identifier: Apache-2.0
// What OctoPrint would answer, made of the spooler's state.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/queue/job.hpp"

namespace web::octoprint {

using Json = nlohmann::json;

// By route below /api/: those that depend on nothing.
std::map<std::string, Json> fixed_answers();
Json user();
// Each file once, the latest of a name.
Json files(const std::vector<queue::Job>& jobs, std::uintmax_t free_bytes);

// One printer, as OctoPrint sees its own.
class View {
 public:
  View(Json printer, Json job) : printer_(std::move(printer)), job_(std::move(job)) {}

  bool is_operational() const;
  bool is_paused() const;
  Json job() const;
  Json printer() const;
  Json connection() const;

 private:
  bool is_printing() const;
  // The words that clients look for.
  std::string state() const;

  Json printer_;  // of the spooler's snapshot
  Json job_;  // that it prints, or null
};
View view_of(const Json& snapshot, const std::string& printer);

}  // namespace web::octoprint
