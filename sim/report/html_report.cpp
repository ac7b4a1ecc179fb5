// SPDX-License-Identifier: Apache-2.0
// Layout of the report's page.
#include "sim/report/html_report.hpp"

#include <fmt/format.h>

#include <exception>
#include <functional>
#include <iterator>

#include "sim/report/plots.hpp"

namespace report {

namespace {

constexpr const char* style = R"css(
body { font: 15px/1.5 Lato, "Segoe UI", Helvetica, Arial, sans-serif; color: #2b323a; background: #f3f5f7;
  margin: 0; }
main { max-width: 1180px; margin: 0 auto; padding: 24px 20px 60px; }
h1 { font-size: 26px; margin: 0; font-weight: 600; } h2 { font-size: 18px; margin: 0 0 10px; }
header { display: flex; align-items: center; gap: 14px; flex-wrap: wrap; margin-bottom: 18px; }
header p { margin: 0; color: #66707b; flex-basis: 100%; }
.badge { border-radius: 99px; padding: 3px 14px; color: #fff; font-weight: 600; }
.completed { background: #1f8a54; } .faulted { background: #c8374b; } .stopped { background: #d98a1f; }
section { background: #fff; border: 1px solid #dfe3e8; border-radius: 10px; padding: 18px 20px;
  margin-top: 18px; overflow-x: auto; }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(165px, 1fr)); gap: 12px; }
.fact { background: #fff; border: 1px solid #dfe3e8; border-radius: 10px; padding: 10px 14px; }
.fact b { display: block; font-size: 20px; font-weight: 600; white-space: nowrap; }
.fact span { color: #66707b; font-size: 13px; } .fact.bad b { color: #c8374b; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 10px; }
svg { width: 100%; height: auto; display: block; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: 5px 10px; border-bottom: 1px solid #eceff2; }
th { color: #66707b; font-weight: 600; font-size: 13px; } th:first-child, td:first-child { text-align: left; }
td.text { text-align: left; font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: 13px;
  overflow-wrap: anywhere; }
tr.error td { color: #c8374b; } .note { color: #66707b; margin: 8px 0 0; font-size: 13px; }
.fault { border-left: 5px solid #c8374b; }
)css";

using Page = fmt::memory_buffer;

template <class... Arguments>
void add(Page& page, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(page), text, std::forward<Arguments>(arguments)...);
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char character : text) {
    switch (character) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += character;
    }
  }
  return result;
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) {
    digits.insert(i - 3, "\u202f");
  }
  return digits;
}

std::string duration(double seconds) {
  const auto whole = static_cast<std::uint64_t>(seconds);
  return whole < 60 ? fmt::format("{:.1f} s", seconds)
                    : fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

void add_fact(Page& page, const std::string& value, const char* what, bool bad = false) {
  add(page, "<div class=\"fact{}\"><b>{}</b><span>{}</span></div>\n", bad ? " bad" : "", value,
      what);
}

void add_facts(Page& page, const Results& results) {
  std::uint64_t illegal = 0, lost = 0;
  for (const AxisResult& axis : results.axes) {
    illegal += axis.illegal_pulses;
    lost += axis.slipped_steps + axis.frame_steps + axis.disabled_pulses;
  }
  const double clocks_per_second =
      results.wall_seconds > 0 ? static_cast<double>(results.cycles) / results.wall_seconds : 0.0;
  add(page, "<div class=\"facts\">\n");
  add_fact(page, duration(results.simulated_seconds), "time on the printer");
  add_fact(page, fmt::format("{:.3g} MHz", results.clock_hz * 1e-6), "clock of the chip");
  add_fact(page, fmt::format("{:.1f} µm", 1000 * results.max_deviation_mm),
           "largest distance from the G-code's lines");
  add_fact(page,
           fmt::format("{} / {}", grouped(results.points_reached),
                       grouped(results.points_reached + results.points_missed)),
           "points reached to the step", results.points_missed > 0);
  add_fact(page, grouped(illegal), "illegal pulses", illegal > 0);
  add_fact(page, grouped(lost), "steps lost otherwise", lost > 0);
  add_fact(page, grouped(results.underruns), "underruns of the queue", results.underruns > 0);
  add_fact(page, fmt::format("{:.1f} %", results.processor_busy_percent), "processor busy");
  add_fact(page, grouped(results.lines_sent), "lines sent");
  add_fact(page, grouped(results.resends), "resends");
  add_fact(page, fmt::format("{:.2f} m", results.length_mm / 1000), "path asked for");
  add_fact(page, fmt::format("{:.2f} M/s", clocks_per_second * 1e-6),
           "clocks simulated per second");
  add(page, "</div>\n");
}

// A picture, or why there is none: the numbers of the report do not depend on gnuplot.
void add_picture(Page& page, const std::function<std::string(const Courses&)>& plot,
                 const Courses& courses) {
  try {
    add(page, "{}\n", plot(courses));
  } catch (const std::exception& error) {
    add(page, "<p class=\"note\">No picture: {}</p>\n", escaped(error.what()));
  }
}

void add_axes(Page& page, const Results& results) {
  add(page,
      "<section><h2>Axes</h2><table><tr><th>axis</th><th>steps forward</th><th>steps backward</th>"
      "<th>final position</th><th>highest step rate</th><th>motor load</th><th>illegal</th>"
      "<th>while off</th><th>slipped</th><th>at the frame</th></tr>\n");
  for (std::size_t i = 0; i < results.axes.size(); ++i) {
    const AxisResult& axis = results.axes[i];
    add(page,
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{:.3f} mm</td><td>{:.2f} kHz</td><td>{:.0f} "
        "%</td>"
        "<td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        static_cast<char>(axis_names[i][0] - 'a' + 'A'), grouped(axis.steps_forward),
        grouped(axis.steps_backward), axis.final_position_mm, axis.max_step_rate_hz / 1000,
        100 * axis.peak_load, axis.illegal_pulses, axis.disabled_pulses, axis.slipped_steps,
        axis.frame_steps);
  }
  add(page, "</table></section>\n");
}

void add_heater_row(Page& page, const char* name, const TemperatureResult& heater) {
  add(page,
      "<tr><td>{}</td><td>{:.1f} °C</td><td>{:.1f} °C</td><td>{}</td><td>± {:.2f} °C</td></tr>\n",
      name, heater.target_c, heater.max_c,
      heater.seconds_to_target >= 0 ? duration(heater.seconds_to_target) : "never", heater.band_c);
}

void add_heaters(Page& page, const Results& results, const Courses& courses) {
  add(page, "<section><h2>Temperatures</h2>\n");
  add_picture(page, plot_temperatures, courses);
  add(page,
      "<table><tr><th>heater</th><th>target</th><th>highest</th><th>time to target</th>"
      "<th>held within</th></tr>\n");
  add_heater_row(page, "hotend", results.hotend);
  add_heater_row(page, "bed", results.bed);
  add(page, "</table></section>\n");
}

void add_messages(Page& page, const Results& results) {
  add(page, "<section><h2>What the chip said</h2>\n");
  if (results.messages.empty()) {
    add(page, "<p class=\"note\">Nothing but acknowledgements and temperatures.</p></section>\n");
    return;
  }
  add(page,
      "<table><tr><th>time</th><th>line of the file</th><th "
      "style=\"text-align:left\">message</th></tr>\n");
  for (const Message& message : results.messages) {
    add(page, "<tr class=\"{}\"><td>{:.3f} s</td><td>{}</td><td class=\"text\">{}</td></tr>\n",
        message.error ? "error" : "", message.seconds,
        message.file_line == 0 ? std::string("–") : std::to_string(message.file_line),
        escaped(message.text));
  }
  add(page, "</table>\n");
  if (results.messages_dropped > 0) {
    add(page, "<p class=\"note\">{} more are left out.</p>\n", results.messages_dropped);
  }
  add(page, "</section>\n");
}

}  // namespace

std::string to_html(const Results& results, const Courses& courses) {
  Page page;
  add(page,
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{} – "
      "StepFabric</title>\n"
      "<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<style>{}</style></head><body><main>\n",
      escaped(results.file), style);
  add(page,
      "<header><h1>{}</h1><span class=\"badge {}\">{}</span><p>printed on the simulated {} by the "
      "chip's own step pulses</p></header>\n",
      escaped(results.file), name_of(results.outcome), name_of(results.outcome),
      escaped(results.machine));
  add_facts(page, results);
  if (!results.fault.empty()) {
    add(page, "<section class=\"fault\"><h2>Fault</h2>{}</section>\n", escaped(results.fault));
  }
  add(page, "<section><h2>The path as printed</h2><div class=\"pair\"><div>\n");
  add_picture(page, plot_path_from_above, courses);
  add(page, "</div><div>\n");
  add_picture(page, plot_path_in_space, courses);
  add(page,
      "</div></div><p class=\"note\">Drawn from the step pulses, not from the G-code. Colour: "
      "height of the "
      "lines on which filament was pushed; grey: travel.</p></section>\n");
  add_heaters(page, results, courses);
  add(page, "<section><h2>Step rates</h2>\n");
  add_picture(page, plot_step_rates, courses);
  add(page, "</section><section><h2>Time between steps</h2>\n");
  add_picture(page, plot_step_intervals, courses);
  add(page, "</section>\n");
  add_axes(page, results);
  add_messages(page, results);
  add(page,
      "<section><h2>Chip</h2><table><tr><th>cycles</th><th>instructions</th><th>queue, deepest</th>"
      "<th>guard stalls</th><th>firmware text</th><th>data</th><th>bss</th><th>stack, "
      "peak</th></tr>"
      "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</"
      "td></tr>"
      "</table></section>\n</main></body></html>\n",
      grouped(results.cycles), grouped(results.instructions), results.max_queue_depth,
      grouped(results.guard_stalls_cycles), grouped(results.firmware.text_bytes),
      grouped(results.firmware.data_bytes), grouped(results.firmware.bss_bytes),
      grouped(results.firmware.stack_peak_bytes));
  return fmt::to_string(page);
}

}  // namespace report
