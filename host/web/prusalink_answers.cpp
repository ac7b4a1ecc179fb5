// SPDX-License-Identifier: Apache-2.0
// The shapes of PrusaLink's answers (its OpenAPI description, version 1).
#include "host/web/prusalink_answers.hpp"

#include <algorithm>
#include <cmath>

namespace web::prusalink {

namespace {

Json storage() {
  return {{"name", storage_name},
          {"type", "LOCAL"},
          {"path", std::string("/") + storage_name},
          {"read_only", false},
          {"available", true}};
}

std::string state_of(const Json& printer, const Json& job) {
  const bool is_there = printer.at("link") == "ready";
  if (!is_there) return "ERROR";
  if (job.is_null()) return printer.at("bed_clear") ? "READY" : "IDLE";
  if (job.at("state") == "paused") return printer.at("waits_for_user") ? "ATTENTION" : "PAUSED";
  return job.at("state") == "starting" ? "BUSY" : "PRINTING";
}

// 0 to 1.
double part_of(const Json& printer, const Json& job) {
  const double commands = job.at("commands"), done = printer.at("done");
  return commands > 0 ? std::clamp(done / commands, 0.0, 1.0) : 0;
}

Json progress_of(const Json& printer, const Json& job) {
  const double part = part_of(printer, job), seconds = job.at("seconds");
  return {{"id", job.at("id")},
          {"progress", std::round(part * 10'000) / 100},
          {"time_remaining", std::llround(seconds * (1 - part))},
          {"time_printing", std::llround(seconds * part)}};
}

Json file_of(const Json& name, const Json& bytes) {
  return {{"name", name},
          {"display_name", name},
          {"path", std::string("/") + storage_name},
          {"size", bytes}};
}

}  // namespace

Json storages(const std::filesystem::space_info& disk) {
  Json one = storage();
  one["free_space"] = disk.available;
  one["total_space"] = disk.capacity;
  return {{"storage_list", Json::array({std::move(one)})}};
}

Json info(const std::string& printer) {
  return {{"name", printer}, {"hostname", "stepfabric"}, {"mmu", false}};
}

Json uploaded(const std::string& name, std::int64_t bytes) {
  Json file = file_of(name, bytes);
  file["type"] = "PRINT_FILE";
  return file;
}

Json status(const Json& printer, const Json& job) {
  Json all{{"printer",
            {{"state", state_of(printer, job)},
             {"temp_nozzle", printer.at("hotend").at(0)},
             {"target_nozzle", printer.at("hotend").at(1)},
             {"temp_bed", printer.at("bed").at(0)},
             {"target_bed", printer.at("bed").at(1)}}},
           {"storage", storage()}};
  if (!job.is_null()) all["job"] = progress_of(printer, job);
  return all;
}

Json job_of(const Json& printer, const Json& job) {
  Json all = progress_of(printer, job);
  all["state"] = state_of(printer, job);
  all["file"] = file_of(job.at("name"), job.at("bytes"));
  return all;
}

}  // namespace web::prusalink
