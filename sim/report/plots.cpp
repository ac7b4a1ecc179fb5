// SPDX-License-Identifier: Apache-2.0
// Scripts and data of the report's pictures.
#include "sim/report/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sim/report/gnuplot.hpp"

namespace report {

namespace {

constexpr std::array<const char*, 4> axis_colours{"#c8374b", "#1f8a54", "#2f62b8", "#d98a1f"};
// More samples than this over the width of a picture only make the file larger.
constexpr std::size_t most_samples = 1500;
constexpr double path_tolerance_mm = 0.02;

constexpr const char* common =
    "set border 3 lc rgb '#8a929c'\nset tics nomirror out scale 0.6 textcolor rgb '#4a525c'\n"
    "set grid lc rgb '#e6e9ed' lt 1\nset key top right textcolor rgb '#4a525c' samplen 2\n";

constexpr const char* height_palette =
    "set palette defined (0 '#3b2f80', 0.25 '#2f6f9f', 0.5 '#25a186', 0.75 '#86c840', 1 "
    "'#f2cf1d')\n"
    "set cblabel 'Z (mm)' textcolor rgb '#4a525c'\nset colorbox noborder\n";

using Script = fmt::memory_buffer;

template <class... Arguments>
void add(Script& script, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(script), text, std::forward<Arguments>(arguments)...);
}

// The lines of one kind as a data block; a blank line lifts the pen.
void add_path(Script& script, const char* name, const std::vector<ToolPoint>& points,
              bool extruding) {
  add(script, "${} << EOD\n", name);
  bool pen_down = false, any = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].extruding != extruding) {
      if (pen_down) {
        add(script, "\n\n");
      }
      pen_down = false;
      continue;
    }
    if (!pen_down) {
      add(script, "{:.3f} {:.3f} {:.3f}\n", points[i - 1].x, points[i - 1].y,
          extruding ? points[i].z : points[i - 1].z);
    }
    add(script, "{:.3f} {:.3f} {:.3f}\n", points[i].x, points[i].y, points[i].z);
    pen_down = any = true;
  }
  add(script, "{}", any ? "EOD\n" : "nan nan nan\nEOD\n");
}

struct Box {
  double x_low = 0, x_high = 1, y_low = 0, y_high = 1, z_low = 0, z_high = 0.1;
};

// Around what was printed; around everything where nothing was.
Box box_of(const std::vector<ToolPoint>& points) {
  const bool printed = std::ranges::any_of(points, &ToolPoint::extruding);
  bool first = true;
  Box box;
  for (const ToolPoint& point : points) {
    if (printed && !point.extruding) {
      continue;
    }
    const double x = point.x, y = point.y, z = point.z;
    box = first ? Box{x, x, y, y, z, z}
                : Box{std::min(box.x_low, x),  std::max(box.x_high, x), std::min(box.y_low, y),
                      std::max(box.y_high, y), std::min(box.z_low, z),  std::max(box.z_high, z)};
    first = false;
  }
  constexpr double margin_mm = 3.0;
  box.x_low -= margin_mm;
  box.x_high += margin_mm;
  box.y_low -= margin_mm;
  box.y_high += margin_mm;
  // Also against the rounding of the data's text, which would clip the lowest layer.
  constexpr double height_margin_mm = 0.05;
  box.z_low -= height_margin_mm;
  box.z_high += height_margin_mm;
  return box;
}

std::string path_script(const Courses& courses, bool in_space) {
  const std::vector<ToolPoint> points = simplified(courses.path, path_tolerance_mm);
  const Box box = box_of(points);
  Script script;
  add(script, "{}{}unset key\n", common, height_palette);
  add_path(script, "travel", points, false);
  add_path(script, "print", points, true);
  add(script, "set xrange [{}:{}]\nset yrange [{}:{}]\nset cbrange [{}:{}]\n", box.x_low,
      box.x_high, box.y_low, box.y_high, box.z_low, box.z_high);
  add(script,
      "set xlabel 'X (mm)' textcolor rgb '#4a525c'\nset ylabel 'Y (mm)' textcolor rgb '#4a525c'\n");
  if (in_space) {
    add(script, "set view 58,30,1.55\nset view equal xyz\nset xyplane at {}\nset zrange [{}:{}]\n",
        box.z_low, box.z_low, box.z_high);
    add(script,
        "unset ztics\nset border 15\nunset colorbox\n"
        "splot $print using 1:2:3:3 with lines lw 1.1 lc palette\n");
  } else {
    add(script,
        "set size ratio -1\nplot $travel using 1:2 with lines lw 0.6 lc rgb '#c3c9d1', "
        "$print using 1:2:3 with lines lw 1.3 lc palette\n");
  }
  return fmt::to_string(script);
}

void add_temperatures(Script& script, const char* name,
                      const std::vector<TemperatureSample>& samples) {
  const std::size_t stride = samples.size() / most_samples + 1;
  add(script, "${} << EOD\n", name);
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    add(script, "{:.2f} {:.2f} {:.1f}\n", samples[i].seconds, samples[i].celsius,
        samples[i].target_c);
  }
  add(script, "{}", samples.empty() ? "0 0 0\nEOD\n" : "EOD\n");
}

}  // namespace

std::string plot_path_from_above(const Courses& courses) {
  return svg_of("above", {860, 720}, path_script(courses, false));
}

std::string plot_path_in_space(const Courses& courses) {
  return svg_of("space", {860, 720}, path_script(courses, true));
}

std::string plot_temperatures(const Courses& courses) {
  Script script;
  add(script, "{}", common);
  add_temperatures(script, "hotend", courses.hotend);
  add_temperatures(script, "bed", courses.bed);
  add(script,
      "set xlabel 'time (s)' textcolor rgb '#4a525c'\nset ylabel '°C' textcolor rgb '#4a525c'\n"
      "set yrange [0:*]\nset key outside top center horizontal\n"
      "plot $hotend using 1:($3>0?$3:NaN) with lines dt 2 lw 1.2 lc rgb '#e5a3ab' title 'hotend, "
      "target', "
      "$bed using 1:($3>0?$3:NaN) with lines dt 2 lw 1.2 lc rgb '#9db8e3' title 'bed, target', "
      "$hotend using 1:2 with lines lw 2 lc rgb '#c8374b' title 'hotend', "
      "$bed using 1:2 with lines lw 2 lc rgb '#2f62b8' title 'bed'\n");
  return svg_of("temperatures", {1100, 360}, fmt::to_string(script));
}

std::string plot_step_rates(const Courses& courses) {
  Script script;
  add(script, "{}", common);
  const std::size_t stride = courses.steps.size() / most_samples + 1;
  add(script, "$rates << EOD\n");
  for (std::size_t i = 0; i < courses.steps.size(); i += stride) {
    std::array<std::uint32_t, StepStatistics::axes> most{};
    for (std::size_t j = i; j < std::min(i + stride, courses.steps.size()); ++j) {
      for (std::size_t axis = 0; axis < most.size(); ++axis) {
        most[axis] = std::max(most[axis], courses.steps[j][axis]);
      }
    }
    const double scale = 1.0 / (1000.0 * StepStatistics::bucket_seconds);
    add(script, "{:.1f} {:.3f} {:.3f} {:.3f} {:.3f}\n",
        static_cast<double>(i) * StepStatistics::bucket_seconds, most[0] * scale, most[1] * scale,
        most[2] * scale, most[3] * scale);
  }
  add(script, "{}", courses.steps.empty() ? "0 0 0 0 0\nEOD\n" : "EOD\n");
  add(script,
      "unset key\nset yrange [0:*]\nset xrange [0:{}]\nset lmargin 9\nset tmargin 0.8\n"
      "set bmargin 1.2\nset ytics autofreq\nset multiplot layout 4,1 margins 0.075,0.985,0.1,0.985 "
      "spacing 0.03\n",
      std::max(1.0, static_cast<double>(courses.steps.size()) * StepStatistics::bucket_seconds));
  for (std::size_t axis = 0; axis < axis_colours.size(); ++axis) {
    const bool last = axis + 1 == axis_colours.size();
    add(script,
        "set format x '{}'\n{}set ylabel '{} (kHz)' textcolor rgb '{}' offset 1\n"
        "plot $rates using 1:{} with fillsteps fs solid 0.35 noborder lc rgb '{}', "
        "$rates using 1:{} with steps lw 0.8 lc rgb '{}'\n",
        last ? "%g" : "", last ? "set xlabel 'time (s)' textcolor rgb '#4a525c'\n" : "",
        static_cast<char>(axis_names[axis][0] - 'a' + 'A'), axis_colours[axis], axis + 2,
        axis_colours[axis], axis + 2, axis_colours[axis]);
  }
  add(script, "unset multiplot\n");
  return svg_of("rates", {1100, 640}, fmt::to_string(script));
}

std::string plot_step_intervals(const Courses& courses) {
  Script script;
  add(script, "{}$intervals << EOD\n", common);
  double lowest = 1e6, highest = 1;
  for (std::size_t bin = 0; bin < StepStatistics::bins; ++bin) {
    const double start = StepStatistics::bin_start_us(bin);
    add(script, "{:.4g}", start);
    for (const StepStatistics::Histogram& histogram : courses.intervals) {
      add(script, " {}", histogram[bin]);
      if (histogram[bin] > 0) {
        lowest = std::min(lowest, start);
        highest = std::max(highest, start);
      }
    }
    add(script, "\n");
  }
  add(script, "EOD\nset logscale x\nset logscale y\nset xrange [{}:{}]\nset yrange [0.8:*]\n",
      std::min(lowest, highest) / 1.5, highest * 2);
  add(script,
      "set xlabel 'time between two steps of an axis (µs)' textcolor rgb '#4a525c'\n"
      "set ylabel 'steps' textcolor rgb '#4a525c'\nset format y '10^{{%T}}'\nplot ");
  for (std::size_t axis = 0; axis < axis_colours.size(); ++axis) {
    add(script, "{}$intervals using 1:(${}>0?${}:0.8) with steps lw 1.6 lc rgb '{}' title '{}'",
        axis == 0 ? "" : ", ", axis + 2, axis + 2, axis_colours[axis],
        static_cast<char>(axis_names[axis][0] - 'a' + 'A'));
  }
  add(script, "\n");
  return svg_of("intervals", {1100, 360}, fmt::to_string(script));
}

}  // namespace report
