// SPDX-License-Identifier: Apache-2.0
// Packing of courses and paths.
#include "sim/report/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/report/markup.hpp"

namespace report {

namespace {

using Json = nlohmann::ordered_json;

constexpr double um_per_mm = 1000, ms_per_s = 1000;

// Rounded values as differences: the sums of the rounded differences do not drift.
class Differences {
 public:
  void put(double value) {
    const std::int64_t rounded = std::llround(value);
    values_.push_back(rounded - last_);
    last_ = rounded;
  }
  Json json() const { return values_; }

 private:
  std::vector<std::int64_t> values_;
  std::int64_t last_ = 0;
};

Json range_json(const RangeCourse& course, double scale) {
  Differences low;
  std::vector<std::int64_t> width;
  for (const Range& range : course.buckets()) {
    const std::int64_t lowest = std::llround(range.low / scale);
    low.put(static_cast<double>(lowest));
    width.push_back(std::llround(range.high / scale) - lowest);
  }
  return {{"dt", course.bucket_seconds()},
          {"scale", scale},
          {"low", low.json()},
          {"width", std::move(width)}};
}

struct PackedLine {
  Differences x, y, z, t;
  std::string kind;

  void put(std::array<float, 3> position, double seconds, char what) {
    x.put(um_per_mm * position[0]);
    y.put(um_per_mm * position[1]);
    z.put(um_per_mm * position[2]);
    t.put(ms_per_s * seconds);
    kind += what;
  }
  Json json() const {
    return {{"x", x.json()}, {"y", y.json()}, {"z", z.json()}, {"t", t.json()}, {"kind", kind}};
  }
};

Json path_json(const std::vector<ToolPoint>& points) {
  PackedLine line;
  for (const ToolPoint& point : points) {
    line.put({point.x, point.y, point.z}, point.seconds, point.extruding ? '1' : '0');
  }
  return line.json();
}

// Kinds: 0 the pen is lifted to here, 1 travel, 2 extrusion, 3 refused.
Json requested_json(const std::vector<RequestedMove>& lines) {
  PackedLine packed;
  Differences file_lines;
  std::array<float, 3> at{};
  for (const RequestedMove& line : lines) {
    const auto file_line = static_cast<double>(line.file_line);
    if (packed.kind.empty() || line.from != at) {
      packed.put(line.from, line.seconds, '0');
      file_lines.put(file_line);
    }
    packed.put(line.to, line.seconds, !line.executed ? '3' : line.extrudes ? '2' : '1');
    file_lines.put(file_line);
    at = line.to;
  }
  Json json = packed.json();
  json["line"] = file_lines.json();
  return json;
}

Json axis_json(std::size_t axis, const Courses& courses) {
  const AxisCourse& course = courses.axes[axis];
  const AxisLimits& limits = courses.limits[axis];
  return {{"name", std::string(1, static_cast<char>(axis_names[axis][0] - 'a' + 'A'))},
          {"limits",
           {{"speed", limits.speed_mm_s},
            {"acceleration", limits.acceleration_mm_s2},
            {"jerk", limits.jerk_mm_s},
            {"steps_per_mm", limits.steps_per_mm}}},
          {"position", range_json(course.position_mm, 0.001)},
          {"speed", range_json(course.speed_mm_s, 0.02)},
          {"acceleration", range_json(course.acceleration_mm_s2, 1.0)}};
}

// More samples than this over a print only make the file larger.
constexpr std::size_t most_samples = 6000;

Json heater_json(const char* name, const std::vector<TemperatureSample>& samples) {
  Differences t, celsius, target;
  std::vector<std::int64_t> duty;
  const std::size_t stride = samples.size() / most_samples + 1;
  for (std::size_t i = stride - 1; i < samples.size(); i += stride) {
    double open = 0;  // of all samples since the one before
    for (std::size_t k = i + 1 - stride; k <= i; ++k) open += samples[k].duty;
    t.put(ms_per_s * samples[i].seconds);
    celsius.put(100 * samples[i].celsius);
    target.put(10 * samples[i].target_c);
    duty.push_back(std::llround(100 * open / static_cast<double>(stride)));
  }
  return {{"name", name},
          {"t", t.json()},
          {"celsius", celsius.json()},
          {"target", target.json()},
          {"duty", std::move(duty)}};
}

Json chip_json(const ChipCourse& chip) {
  Json underruns = Json::array();
  for (const Underruns& some : chip.underruns) {
    underruns.push_back({std::round(1000 * some.seconds) / 1000, some.count});
  }
  return {{"queue_depth", range_json(chip.queue_depth, 1.0)},
          {"busy_percent", range_json(chip.processor_busy_percent, 0.1)},
          {"underruns", std::move(underruns)}};
}

Json missed_json(const std::vector<MissedPoint>& points) {
  Json json = Json::array();
  for (const MissedPoint& point : points) {
    json.push_back(
        {{"x", point.axes[0].wanted_mm},
         {"y", point.axes[1].wanted_mm},
         {"z", point.axes[2].wanted_mm},
         {"reached_x", point.axes[0].reached_mm},
         {"reached_y", point.axes[1].reached_mm},
         {"reached_z", point.axes[2].reached_mm},
         {"words", fmt::format("line {}: {}\n{}", point.file_line, point.text, words_of(point))}});
  }
  return json;
}

Json marks_json(const Results& results, const Courses& courses) {
  Json json = Json::array();
  for (const MissedPoint& point : results.findings.missed) json.push_back({{"t", point.seconds}});
  for (const RefusedLine& line : results.findings.refused) {
    if (const RefusalPlace place = place_of(line, results, courses); place.known) {
      json.push_back({{"t", place.seconds}});
    }
  }
  return json;
}

Json intervals_json(const Courses& courses) {
  Json counts = Json::array();
  for (const StepStatistics::Histogram& histogram : courses.intervals) counts.push_back(histogram);
  return {{"bins_per_decade", StepStatistics::bins_per_decade}, {"axes", std::move(counts)}};
}

}  // namespace

std::string words_of(const MissedPoint& point) {
  std::string words;
  for (std::size_t i = 0; i < point.axes.size(); ++i) {
    const AxisArrival& axis = point.axes[i];
    if (!axis.missed) continue;
    words += fmt::format("{}{} {:+} steps: {:.3f} mm where {:.3f} mm are asked",
                         words.empty() ? "" : "\n", axis_titles[i],
                         axis.reached_steps - axis.wanted_steps, axis.reached_mm, axis.wanted_mm);
  }
  return words;
}

RefusalPlace place_of(const RefusedLine& line, const Results& results, const Courses& courses) {
  const auto asked = std::ranges::find_if(courses.asked, [&](const RequestedMove& candidate) {
    return !candidate.executed && candidate.file_line == line.file_line;
  });
  if (asked != courses.asked.end()) return {true, asked->seconds, true, asked->from, asked->to};
  const auto message = std::ranges::find(results.messages, line.file_line, &Message::file_line);
  if (message != results.messages.end()) return {true, message->seconds, false, {}, {}};
  return {};
}

std::string page_data(const Results& results, const Courses& courses) {
  Json json;
  json["seconds"] = results.simulated_seconds;
  json["half_window_s"] = AxisCourses::half_window_seconds;
  json["path"] = path_json(courses.path);
  json["asked"] = requested_json(courses.asked);
  json["missed"] = missed_json(results.findings.missed);
  json["marks"] = marks_json(results, courses);
  json["axes"] = Json::array();
  for (std::size_t i = 0; i < courses.axes.size(); ++i) {
    json["axes"].push_back(axis_json(i, courses));
  }
  json["heaters"] = {heater_json("hotend", courses.hotend), heater_json("bed", courses.bed)};
  json["chip"] = chip_json(courses.chip);
  json["intervals"] = intervals_json(courses);
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t i = text.find('<'); i != std::string::npos; i = text.find('<', i)) {
    text.replace(i, 1, "\\u003c");
  }
  return text;
}

}  // namespace report
