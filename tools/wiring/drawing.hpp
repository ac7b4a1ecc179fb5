// SPDX-License-Identifier: Apache-2.0
// A picture in SVG, in units of a grid.
#pragma once

#include <string>
#include <vector>

#include "tools/wiring/description.hpp"

namespace wiring {

enum class Anchor { start, middle, end };

struct Label {
  Anchor anchor = Anchor::start;
  double size = 10;  // in pixels
  bool is_bold = false;
  std::string color = "#222";
};

class Drawing {
 public:
  // In grid units.
  Drawing(double width, double height) : width_(width), height_(height) {}

  // All that follows is moved there.
  void move_to(Place origin) { origin_ = origin; }

  void line(const std::vector<Place>& points, const std::string& color = "#222",
            double width = 1.2);
  void polygon(const std::vector<Place>& points, const std::string& fill);
  void rectangle(Place corner, Place size, const std::string& fill,
                 const std::string& color = "#222");
  void circle(Place center, double radius, const std::string& fill,
              const std::string& color = "#222");
  void text(Place at, const std::string& words, const Label& label);
  // What programs find again in the picture, around what is drawn until end_group().
  void begin_group(const std::string& attributes) { body_ += "<g " + attributes + ">\n"; }
  void end_group() { body_ += "</g>\n"; }

  std::string svg(const std::string& title) const;

 private:
  std::string points_of(const std::vector<Place>& points) const;
  double x(double units) const { return (origin_.x + units) * pixels_; }
  double y(double units) const { return (origin_.y + units) * pixels_; }

  static constexpr double pixels_ = 10;
  double width_, height_;
  Place origin_;
  std::string body_;
};

}  // namespace wiring
