// SPDX-License-Identifier: Apache-2.0
// /proc/stat, /proc/meminfo, and the process's own usage.
#include "host/moonraker/machine.hpp"

#include <sys/resource.h>
#include <sys/utsname.h>

#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "host/moonraker/core.hpp"

namespace moonraker {

using Json = nlohmann::json;

namespace {

// In kB; 0 where the file does not have it.
std::int64_t memory(const char* file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(name + ":")) continue;
    std::int64_t value = 0;
    std::istringstream(line.substr(name.size() + 1)) >> value;
    return value;
  }
  return 0;
}

double process_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Of all processors together, in ticks.
void read_load(double& busy, double& all) {
  std::ifstream stream("/proc/stat");
  std::string name;
  stream >> name;
  double ticks = 0;
  busy = all = 0;
  for (int column = 0; column < 8 && stream >> ticks; ++column) {
    all += ticks;
    const bool is_idle = column == 3 || column == 4;
    if (!is_idle) busy += ticks;
  }
}

}  // namespace

Json process_stats(ProcessorTime& last, std::size_t connections) {
  ProcessorTime now{.process = process_seconds(), .at = event_time()};
  read_load(now.busy, now.all);
  const double passed = now.at - last.at, ticks = now.all - last.all;
  const double usage = last.at > 0 && passed > 0 ? (now.process - last.process) / passed * 100 : 0;
  const double load = last.at > 0 && ticks > 0 ? (now.busy - last.busy) / ticks * 100 : 0;
  last = now;
  const std::int64_t total = memory("/proc/meminfo", "MemTotal");
  const std::int64_t available = memory("/proc/meminfo", "MemAvailable");
  return {
      {"moonraker_stats",
       {{"time", unix_time()},
        {"cpu_usage", usage},
        {"memory", memory("/proc/self/status", "VmRSS")},
        {"mem_units", "kB"}}},
      {"cpu_temp", nullptr},
      {"network", Json::object()},
      {"system_cpu_usage", {{"cpu", load}}},
      {"system_memory", {{"total", total}, {"available", available}, {"used", total - available}}},
      {"websocket_connections", connections}};
}

Json system_info() {
  utsname names{};
  uname(&names);
  return {{"cpu_info",
           {{"cpu_count", std::thread::hardware_concurrency()},
            {"bits", std::to_string(sizeof(void*) * 8) + "bit"},
            {"processor", names.machine},
            {"cpu_desc", ""},
            {"serial_number", ""},
            {"hardware_desc", ""},
            {"model", ""},
            {"total_memory", memory("/proc/meminfo", "MemTotal")},
            {"memory_units", "kB"}}},
          {"sd_info", Json::object()},
          {"distribution",
           {{"name", names.sysname},
            {"id", ""},
            {"version", names.release},
            {"version_parts", Json::object()},
            {"like", ""},
            {"codename", ""}}},
          {"available_services", Json::array()},
          {"service_state", Json::object()},
          {"instance_ids", Json::object()},
          {"network", Json::object()},
          {"canbus", Json::object()},
          {"python", Json::object()},
          {"virtualization", {{"virt_type", "none"}, {"virt_identifier", "none"}}}};
}

}  // namespace moonraker
