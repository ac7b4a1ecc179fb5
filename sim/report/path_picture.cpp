// SPDX-License-Identifier: Apache-2.0
// SVG paths in hundredths of a millimetre, relative so that they are short.
#include "sim/report/path_picture.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/report/markup.hpp"

namespace report {

namespace {

constexpr double units_per_mm = 100;
// A tenth of this is still seen on a screen of 1000 pixels if the print is 20 mm wide.
constexpr double tolerance_mm = 0.02;

struct Place {
  std::int64_t x{}, y{};
  bool operator==(const Place&) const = default;
};

// SVG counts y downwards.
Place place_of(double x_mm, double y_mm) {
  return {std::llround(units_per_mm * x_mm), -std::llround(units_per_mm * y_mm)};
}

class Pen {
 public:
  void line(Place from, Place to) {
    if (from == to) return;
    if (!down_ || from != at_) add(text_, "M{} {}", from.x, from.y);
    add(text_, "l{} {}", to.x - from.x, to.y - from.y);
    at_ = to;
    down_ = true;
  }
  std::string text() const { return fmt::to_string(text_); }

 private:
  Page text_;
  Place at_;
  bool down_ = false;
};

struct Box {
  double x_low = 1e9, x_high = -1e9, y_low = 1e9, y_high = -1e9;

  void put(double x, double y) {
    x_low = std::min(x_low, x);
    x_high = std::max(x_high, x);
    y_low = std::min(y_low, y);
    y_high = std::max(y_high, y);
  }
  bool empty() const { return x_high < x_low; }
};

// Around what was printed; around everything where nothing was.
Box box_of(const Courses& courses) {
  const bool printed = std::ranges::any_of(courses.path, &ToolPoint::extruding);
  Box box;
  for (std::size_t i = 0; i < courses.path.size(); ++i) {
    const bool next_prints = i + 1 < courses.path.size() && courses.path[i + 1].extruding;
    if (!printed || courses.path[i].extruding || next_prints) {
      box.put(courses.path[i].x, courses.path[i].y);
    }
  }
  return box.empty() ? Box{0, 10, 0, 10} : box;
}

std::string printed_lines(const std::vector<ToolPoint>& points, bool extruding) {
  Pen pen;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].extruding == extruding) {
      pen.line(place_of(points[i - 1].x, points[i - 1].y), place_of(points[i].x, points[i].y));
    }
  }
  return pen.text();
}

std::string requested_lines(const std::vector<RequestedMove>& lines,
                            const std::function<bool(const RequestedMove&)>& wanted) {
  Pen pen;
  for (const RequestedMove& line : lines) {
    if (wanted(line)) {
      pen.line(place_of(line.from[0], line.from[1]), place_of(line.to[0], line.to[1]));
    }
  }
  return pen.text();
}

void add_lines(Page& svg, const char* colour, double width, const std::string& path) {
  if (!path.empty()) {
    add(svg,
        "<path fill=\"none\" stroke=\"var(--{})\" stroke-width=\"{}\" stroke-linecap=\"round\" "
        "vector-effect=\"non-scaling-stroke\" d=\"{}\"/>\n",
        colour, width, path);
  }
}

}  // namespace

std::string path_picture(const Results& results, const Courses& courses) {
  const std::vector<ToolPoint> points = simplified(courses.path, tolerance_mm);
  const Box box = box_of(courses);
  const double size = std::max({box.x_high - box.x_low, box.y_high - box.y_low, 1.0});
  const double margin = 0.05 * size;
  const Place corner = place_of(box.x_low - margin, box.y_high + margin);
  const Place opposite = place_of(box.x_high + margin, box.y_low - margin);
  Page svg;
  add(svg,
      "<svg class=\"path\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
      "aria-label=\"path from above\" viewBox=\"{} {} {} {}\">\n",
      corner.x, corner.y, opposite.x - corner.x, opposite.y - corner.y);
  add_lines(svg, "asked", 5, requested_lines(courses.asked, [](const RequestedMove& line) {
              return line.executed && line.extrudes;
            }));
  add_lines(svg, "travel", 0.6, printed_lines(points, false));
  add_lines(svg, "accent", 1.2, printed_lines(points, true));
  add_lines(svg, "bad", 1.5, requested_lines(courses.asked, [](const RequestedMove& line) {
              return !line.executed;
            }));
  for (const MissedPoint& point : results.findings.missed) {
    const Place at = place_of(point.axes[0].wanted_mm, point.axes[1].wanted_mm);
    add(svg,
        "<circle class=\"missed\" cx=\"{}\" cy=\"{}\" r=\"{:.0f}\" fill=\"none\" "
        "stroke=\"var(--bad)\" stroke-width=\"2\" vector-effect=\"non-scaling-stroke\"/>\n",
        at.x, at.y, 0.01 * size * units_per_mm);
  }
  add(svg, "</svg>\n");
  return fmt::to_string(svg);
}

}  // namespace report
