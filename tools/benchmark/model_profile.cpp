// SPDX-License-Identifier: Apache-2.0
// One profiled run of each work, as JSON and as tables.
#include "tools/benchmark/model_profile.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

namespace benchmarks {

namespace {

struct Named {
  const char* key;
  const char* title;
};

// In the order of sim::Activity.
constexpr std::array<Named, sim::activity_count> activities{{
    {"loop", "loop and pins"},
    {"processor_model", "model of the processor"},
    {"leaps", "leaps"},
    {"netlist", "evaluation of the netlist"},
    {"devices", "devices and plants"},
    {"host_and_report", "host and report"},
}};

// In the order of sim::LeapEnd.
constexpr std::array<Named, sim::leap_end_count> leap_ends{{
    {"device", "a device's time"},
    {"processor", "the processor"},
    {"timer", "timer"},
    {"converter", "temperature converter"},
    {"heater", "heater control"},
    {"motion_watchdog", "motion watchdog"},
    {"time_base", "time base"},
    {"fan", "fan"},
}};

using Counted = std::pair<Named, std::uint64_t>;

std::array<Counted, 6> evaluated_for(const sim::EvaluationCounts& counts) {
  return {{{{"after_input", "an input that changed"}, counts.after_input},
           {{"processor", "processor at the bus"}, counts.processor},
           {{"registers", "registers and bus"}, counts.registers},
           {{"axes", "axes of the step generator"}, counts.axes},
           {{"peripherals", "peripherals"}, counts.peripherals},
           {{"free_running_alone", "counters, too near an event"}, counts.free_running_alone}}};
}

double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

template <typename Value>
void add_row(std::string& table, const char* title, const std::vector<ProfiledWork>& works,
             Value value) {
  table += fmt::format("  {:<30}", title);
  for (const ProfiledWork& work : works) table += fmt::format(" {:>18}", value(work));
  table += "\n";
}

std::string percent(double share) { return fmt::format("{:.1f}%", 100 * share); }

const sim::EvaluationCounts& counts_of(const ProfiledWork& work) {
  return work.measured.profile.evaluations;
}

}  // namespace

std::uint64_t ProfiledWork::samples() const {
  const ActivityCounts& counts = measured.profile.samples;
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

double ProfiledWork::share(sim::Activity activity) const {
  return ratio(measured.profile.samples[static_cast<std::size_t>(activity)], samples());
}

std::vector<ProfiledWork> profile_model(const ModelScope& scope,
                                        const std::function<void(const std::string&)>& say) {
  std::vector<ProfiledWork> works;
  for (const NamedRun& work : model_works) {
    say(fmt::format("profile of the model, {}", work.name));
    works.push_back({.name = work.name,
                     .clock_hz = work.clock_hz,
                     .measured = work.run(scope, {.clock_hz = work.clock_hz, .profiled = true})});
  }
  return works;
}

std::string to_json(const std::vector<ProfiledWork>& works) {
  nlohmann::ordered_json json{{"benchmark", "model_profile"}};
  for (const ProfiledWork& work : works) {
    const sim::EvaluationCounts& counts = counts_of(work);
    nlohmann::ordered_json shares, ends, evaluated;
    for (std::size_t i = 0; i < activities.size(); ++i) {
      shares[activities[i].key] = work.share(static_cast<sim::Activity>(i));
    }
    for (std::size_t i = 0; i < leap_ends.size(); ++i) {
      ends[leap_ends[i].key] = counts.leaps_ended_by[i];
    }
    for (const auto& [named, count] : evaluated_for(counts)) evaluated[named.key] = count;
    json["works"].push_back({{"name", work.name},
                             {"clock_hz", work.clock_hz},
                             {"clocks", work.measured.clocks},
                             {"processor_seconds", work.measured.seconds},
                             {"simulation_thread_seconds", work.measured.profile.seconds},
                             {"samples", work.samples()},
                             {"shares", shares},
                             {"leaps", counts.leaps},
                             {"leapt_clocks", counts.leapt_clocks},
                             {"leaps_ended_by", ends},
                             {"evaluated_clocks", counts.evaluated_clocks},
                             {"evaluated_for", evaluated}});
  }
  return json.dump(2) + "\n";
}

std::string to_table(const std::vector<ProfiledWork>& works) {
  std::string table;
  add_row(table, "", works, [](const ProfiledWork& work) { return work.name; });
  table += "time of the simulation's thread\n";
  for (std::size_t i = 0; i < activities.size(); ++i) {
    add_row(table, activities[i].title, works, [i](const ProfiledWork& work) {
      return percent(work.share(static_cast<sim::Activity>(i)));
    });
  }
  add_row(table, "seconds", works, [](const ProfiledWork& work) {
    return fmt::format("{:.2f}", work.measured.profile.seconds);
  });
  add_row(table, "samples", works, [](const ProfiledWork& work) { return work.samples(); });
  table += "clocks\n";
  add_row(table, "all", works, [](const ProfiledWork& work) { return work.measured.clocks; });
  add_row(table, "leapt over", works, [](const ProfiledWork& work) {
    return percent(ratio(counts_of(work).leapt_clocks, work.measured.clocks));
  });
  add_row(table, "evaluated", works, [](const ProfiledWork& work) {
    return percent(ratio(counts_of(work).evaluated_clocks, work.measured.clocks));
  });
  table += "evaluated clocks, by what had something to do in them (some had several)\n";
  for (std::size_t i = 0; i < evaluated_for({}).size(); ++i) {
    add_row(table, evaluated_for({})[i].first.title, works, [i](const ProfiledWork& work) {
      const sim::EvaluationCounts& counts = counts_of(work);
      return percent(ratio(evaluated_for(counts)[i].second, counts.evaluated_clocks));
    });
  }
  table += "leaps, by what ended them\n";
  add_row(table, "all", works, [](const ProfiledWork& work) { return counts_of(work).leaps; });
  for (std::size_t i = 0; i < leap_ends.size(); ++i) {
    add_row(table, leap_ends[i].title, works, [i](const ProfiledWork& work) {
      return percent(ratio(counts_of(work).leaps_ended_by[i], counts_of(work).leaps));
    });
  }
  return table;
}

}  // namespace benchmarks
