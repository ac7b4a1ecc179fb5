// SPDX-License-Identifier: Apache-2.0
// Tables of heaters, axes, messages and the chip.
#include "sim/report/html_parts.hpp"

namespace report {

namespace {

void add_heater_row(Page& page, const char* name, const TemperatureResult& heater) {
  add(page,
      "<tr><td class=\"text\">{}</td><td>{}</td><td>{:.1f} °C</td><td>{}</td><td>{}</td></tr>\n",
      name, heater.target_c > 0 ? fmt::format("{:.1f} °C", heater.target_c) : "–", heater.max_c,
      heater.target_c <= 0            ? "–"
      : heater.seconds_to_target >= 0 ? duration(heater.seconds_to_target)
                                      : "never",
      heater.band_c > 0 ? fmt::format("± {:.2f} °C", heater.band_c) : "–");
}

// "heat 2, commands 1"
std::string overruns(const Results& results) {
  std::string text;
  for (const TaskResult& task : results.tasks) {
    if (task.overruns == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", task.name, grouped(task.overruns));
  }
  return text.empty() ? "none" : text;
}

}  // namespace

void add_heaters(Page& page, const Results& results) {
  add(page,
      "<section><h2>Heaters</h2><div class=\"scroll\"><table><tr><th "
      "class=\"text\">heater</th><th>target</th><th>highest</th><th>time to target</th>"
      "<th>held within</th></tr>\n");
  add_heater_row(page, "hotend", results.hotend);
  if (results.motors == motor_count) add_heater_row(page, "second hotend", results.second_hotend);
  add_heater_row(page, "bed", results.bed);
  add(page, "</table></div></section>\n");
}

void add_axes(Page& page, const Results& results) {
  add(page,
      "<section id=\"axes\"><h2>Axes</h2><div class=\"scroll\"><table><tr><th "
      "class=\"text\">axis</th><th>steps forward</th><th>backward</th><th>final position</th>"
      "<th>highest step rate</th><th>motor load</th><th>illegal</th><th>while off</th>"
      "<th>slipped</th><th>at the frame</th></tr>\n");
  for (std::size_t i = 0; i < results.motors; ++i) {
    const AxisResult& axis = results.axes[i];
    add(page,
        "<tr><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.2f}&nbsp;kHz</td>"
        "<td>{:.0f}&nbsp;%</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        axis_titles[i], grouped(axis.steps_forward), grouped(axis.steps_backward),
        length_text(axis.final_position_mm), axis.max_step_rate_hz / 1000, 100 * axis.peak_load,
        grouped(axis.illegal_pulses), grouped(axis.disabled_pulses), grouped(axis.slipped_steps),
        grouped(axis.frame_steps));
  }
  add(page, "</table></div></section>\n");
}

void add_messages(Page& page, const Results& results) {
  add(page, "<section><h2>What the chip said</h2>\n");
  if (results.messages.empty()) {
    add(page, "<p class=\"note\">Nothing but acknowledgements and temperatures.</p></section>\n");
    return;
  }
  add(page,
      "<div class=\"scroll\"><table><tr><th>line</th><th>time</th>"
      "<th class=\"text\">message</th></tr>\n");
  for (const Message& message : results.messages) {
    add(page,
        "<tr{}><td>{}</td><td><a href=\"#path\" data-t=\"{:.4f}\">{:.3f}&nbsp;s</a></td>"
        "<td class=\"text\">{}</td></tr>\n",
        message.error ? " class=\"error\"" : "",
        message.file_line == 0 ? std::string("–") : std::to_string(message.file_line),
        message.seconds, message.seconds, escaped(message.text));
  }
  add(page, "</table></div>\n");
  if (results.messages_dropped > 0) {
    add(page, "<p class=\"note\">{} more are left out.</p>\n", grouped(results.messages_dropped));
  }
  add(page, "</section>\n");
}

void add_chip(Page& page, const Results& results) {
  const auto row = [&page](const char* what, const std::string& value) {
    add(page, "<tr><td class=\"text\">{}</td><td>{}</td></tr>\n", what, value);
  };
  add(page, "<section><h2>Chip and firmware</h2><div class=\"scroll\"><table>\n");
  row("clocks", grouped(results.cycles));
  row("instructions", grouped(results.instructions));
  row("longest pass of the firmware's loop", grouped(results.longest_pass_clocks) + " clocks");
  row("its tasks that took longer than their budget", overruns(results));
  row("queue of the step generator, deepest", grouped(results.max_queue_depth));
  row("clocks for which the guard delayed steps", grouped(results.guard_stalls_cycles));
  row("firmware: code and constants", grouped(results.firmware.text_bytes) + " bytes");
  row("data", grouped(results.firmware.data_bytes + results.firmware.bss_bytes) + " bytes");
  row("stack at its peak", grouped(results.firmware.stack_peak_bytes) + " bytes");
  row("lines sent, with resends", grouped(results.lines_sent));
  row("simulated in", duration(results.wall_seconds));
  add(page, "</table></div></section>\n");
}

}  // namespace report
