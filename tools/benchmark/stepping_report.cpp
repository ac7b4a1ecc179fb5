// SPDX-License-Identifier: Apache-2.0
// JSON and the table.
#include "tools/benchmark/stepping_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tools/benchmark/published_figures.hpp"
#include "tools/benchmark/rate_pairs.hpp"

namespace benchmarks {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json jitter_json(const Jitter& jitter) {
  return {{"intervals", jitter.intervals},
          {"min_clocks", jitter.shortest},
          {"max_clocks", jitter.longest},
          {"mean_clocks", rounded(jitter.mean)},
          {"standard_deviation_clocks", rounded(jitter.standard_deviation)}};
}

Json pair_json(const Limit& hardware, const Limit& software, double clock_hz) {
  Json json{{"hardware_steps_per_second_per_axis", rounded(clock_hz / hardware.interval_clocks)},
            {"software_steps_per_second_per_axis", rounded(clock_hz / software.interval_clocks)},
            {"hardware_clocks_per_step", hardware.interval_clocks},
            {"software_clocks_per_step", software.interval_clocks},
            {"hardware_largest_lateness_clocks", rounded(hardware.largest_lateness_clocks)},
            {"software_largest_lateness_clocks", rounded(software.largest_lateness_clocks)}};
  const auto tell_of = [&](const char* stepping, const Limit& limit) {
    const std::string name(stepping);
    if (!limit.limited_by.empty()) json[name + "_limited_by"] = limit.limited_by;
    if (limit.also_clocks != 0) json[name + "_also_clocks_per_step"] = limit.also_clocks;
  };
  tell_of("hardware", hardware);
  tell_of("software", software);
  return json;
}

Json figures_json(const Figures& figures, double clock_hz) {
  Json json;
  for (const JitterFigure& figure : figures.jitter) {
    Json row = jitter_json(figure.jitter);
    row["asked_clocks"] = figure.interval_clocks;
    json["jitter"].push_back(row);
  }
  for (const Train& train : figures.trains) {
    Json row = jitter_json(train.jitter);
    row["serial_line"] = train.saturated ? "saturated" : "silent";
    row["hertz"] = rounded(train.hertz);
    json["train_10_khz"].push_back(row);
  }
  for (const Share& share : figures.shares) {
    json["processor"].push_back({{"clocks_per_tick", share.interval_clocks},
                                 {"ticks_per_second", rounded(clock_hz / share.interval_clocks)},
                                 {"busy_percent", rounded(100 * share.busy)},
                                 {"clean", share.clean}});
  }
  for (const DriverShare& figure : figures.driver_shares) {
    json["processor_with_driver"].push_back(
        {{"driver", figure.guard.driver},
         {"clocks_per_tick", figure.share.interval_clocks},
         {"ticks_per_second", rounded(clock_hz / figure.share.interval_clocks)},
         {"busy_percent", rounded(100 * figure.share.busy)},
         {"clean", figure.share.clean}});
  }
  return json;
}

Json print_json(const PrintFigure& print) {
  return {{"result", print.result},
          {"late_ticks", print.late_ticks},
          {"underruns", print.underruns},
          {"illegal_pulses", print.illegal_pulses},
          {"processor_busy_percent", print.busy_percent},
          {"max_deviation_mm", print.max_deviation_mm},
          {"max_step_rate_hz", print.max_step_rate_hz},
          {"seconds", print.seconds},
          {"same_steps_as_hardware", print.same_steps}};
}

void add_rates(fmt::memory_buffer& out, const Comparison& comparison, Rule rule) {
  const double clock = comparison.clock_hz;
  const std::string title =
      rule == Rule::clean
          ? fmt::format("Highest clean rates at {:.3g} MHz", clock * 1e-6)
          : fmt::format("The same, each tick within {:.3g} us", comparison.tolerance_us);
  fmt::format_to(std::back_inserter(out), "{:<50} {:>19} {:>17}  ratio  latest tick, clocks\n",
                 title, "hardware", "software");
  for (const RatePair& pair : rate_pairs(comparison)) {
    const Limit& hardware = pair.hardware.of(rule);
    const Limit& software = pair.software.of(rule);
    fmt::format_to(std::back_inserter(out),
                   "{:<50} {:>11.0f} steps/s {:>9.0f} steps/s {:>6.1f} {:>9.0f} {:>9.0f}\n",
                   pair.text, clock / hardware.interval_clocks, clock / software.interval_clocks,
                   pair.ratio(rule), hardware.largest_lateness_clocks,
                   software.largest_lateness_clocks);
  }
}

}  // namespace

std::string to_json(const Comparison& comparison) {
  Json json{{"benchmark", "stepping"},
            {"clock_hz", comparison.clock_hz},
            {"tolerance_us", comparison.tolerance_us}};
  const auto add = [&](Rule rule, const char* rate, const char* ratio) {
    for (const RatePair& pair : rate_pairs(comparison)) {
      json[rate][pair.name] =
          pair_json(pair.hardware.of(rule), pair.software.of(rule), comparison.clock_hz);
      json[ratio][pair.name] = rounded(pair.ratio(rule));
    }
  };
  add(Rule::clean, "highest_clean_rate", "ratio");
  add(Rule::punctual, "highest_punctual_rate", "punctual_ratio");
  for (const Figures& figures : comparison.figures) {
    json[name_of(figures.stepping)] = figures_json(figures, comparison.clock_hz);
  }
  if (comparison.prints) {
    json["print"] = {{"file", comparison.print_file},
                     {"clock_hz", comparison.print_clock_hz},
                     {"hardware", print_json((*comparison.prints)[0])},
                     {"software", print_json((*comparison.prints)[1])}};
  }
  for (const PublishedFigure& figure : published_figures) {
    json["published"].push_back(
        {{"system", figure.system},
         {"clock_mhz", figure.clock_mhz},
         {"steps_per_second", rounded(figure.steps_per_second())},
         {"steps_per_million_clocks", rounded(figure.steps_per_million_clocks())},
         {"remark", figure.remark},
         {"source", figure.source}});
  }
  return json.dump(2) + "\n";
}

std::string to_table(const Comparison& comparison) {
  fmt::memory_buffer out;
  const auto add = [&]<class... Arguments>(fmt::format_string<Arguments...> format,
                                           Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
  };
  const Figures& hardware = comparison.figures[0];
  const Figures& software = comparison.figures[1];
  const double clock = comparison.clock_hz;
  add_rates(out, comparison, Rule::clean);
  add_rates(out, comparison, Rule::punctual);
  for (const Figures& figures : comparison.figures) {
    for (const JitterFigure& figure : figures.jitter) {
      add("jitter, {}: every {} clocks asked: {} to {}, standard deviation {:.3f}\n",
          name_of(figures.stepping), figure.interval_clocks, figure.jitter.shortest,
          figure.jitter.longest, figure.jitter.standard_deviation);
    }
    for (const Train& train : figures.trains) {
      add("10 kHz, {}, serial line {}: {:.3f} Hz, intervals {} to {} clocks\n",
          name_of(figures.stepping), train.saturated ? "saturated" : "silent", train.hertz,
          train.jitter.shortest, train.jitter.longest);
    }
  }
  for (std::size_t i = 0; i < hardware.shares.size(); ++i) {
    const Share& hard = hardware.shares[i];
    const Share& soft = software.shares[i];
    add("processor, four axes at {:>7.0f} ticks/s: {:5.1f} % {:5.1f} %{}\n",
        clock / hard.interval_clocks, 100 * hard.busy, 100 * soft.busy,
        soft.clean ? "" : " (not clean)");
  }
  for (std::size_t i = 0; i < hardware.driver_shares.size(); ++i) {
    const DriverShare& hard = hardware.driver_shares[i];
    const DriverShare& soft = software.driver_shares[i];
    add("processor, four axes at {:>7.0f} ticks/s, {:<7}: {:5.1f} % {:5.1f} %{}\n",
        clock / hard.share.interval_clocks, hard.guard.driver, 100 * hard.share.busy,
        100 * soft.share.busy, soft.share.clean ? "" : " (not clean)");
  }
  if (comparison.prints) {
    for (const PrintFigure& print : *comparison.prints) {
      add("print of {} at {:.3g} MHz, {}: {}, processor {:.1f} %, {} ticks late, {} underruns, "
          "{} illegal pulses\n",
          comparison.print_file, comparison.print_clock_hz * 1e-6,
          &print == &(*comparison.prints)[0] ? "hardware" : "software", print.result,
          print.busy_percent, print.late_ticks, print.underruns, print.illegal_pulses);
    }
  }
  return fmt::to_string(out);
}

}  // namespace benchmarks
