// SPDX-License-Identifier: Apache-2.0
// JSON and the table.
#include "tools/benchmark/stepping_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tools/benchmark/published_figures.hpp"

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

Json figures_json(const Figures& figures, double clock_hz) {
  Json json;
  for (const CleanRate& rate : figures.clean) {
    json["clean"].push_back(
        {{"axes", rate.axes},
         {"guard_clocks", rate.guard_clocks},
         {"clocks_per_step", rate.lines_clocks},
         {"steps_per_second_per_axis", rounded(clock_hz / rate.lines_clocks)},
         {"clocks_per_step_within_a_line", rate.one_line_clocks},
         {"steps_per_second_within_a_line", rounded(clock_hz / rate.one_line_clocks)}});
  }
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

}  // namespace

std::string to_json(const Comparison& comparison) {
  Json json{{"benchmark", "stepping"}, {"clock_hz", comparison.clock_hz}};
  for (const Figures& figures : comparison.figures) {
    json[name_of(figures.stepping)] = figures_json(figures, comparison.clock_hz);
  }
  const auto& hardware = comparison.figures[0].clean;
  const auto& software = comparison.figures[1].clean;
  for (std::size_t i = 0; i < hardware.size(); ++i) {
    json["ratio"].push_back(
        {{"axes", hardware[i].axes},
         {"guard_clocks", hardware[i].guard_clocks},
         {"lines", rounded(double(software[i].lines_clocks) / hardware[i].lines_clocks)},
         {"within_a_line",
          rounded(double(software[i].one_line_clocks) / hardware[i].one_line_clocks)}});
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
         {"steps_per_second", figure.steps_per_second},
         {"steps_per_million_clocks", rounded(figure.steps_per_second / figure.clock_mhz)},
         {"remark", figure.remark}});
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
  add("At {:.3g} MHz              {:>22} {:>22}  ratio\n", clock * 1e-6, "hardware", "software");
  for (std::size_t i = 0; i < hardware.clean.size(); ++i) {
    const CleanRate& hard = hardware.clean[i];
    const CleanRate& soft = software.clean[i];
    const auto row = [&](const char* what, std::uint32_t a, std::uint32_t b) {
      add("{} {}, guard {:2} {:>9} {:>14.0f} steps/s {:>14.0f} steps/s {:>6.1f}\n", hard.axes,
          hard.axes == 1 ? "axis" : "axes", hard.guard_clocks, what, clock / a, clock / b,
          double(b) / a);
    };
    row("lines", hard.lines_clocks, soft.lines_clocks);
    row("one line", hard.one_line_clocks, soft.one_line_clocks);
  }
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
