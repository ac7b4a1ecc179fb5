// SPDX-License-Identifier: Apache-2.0
// Writes the elements of an SVG.
#include "tools/wiring/drawing.hpp"

#include <fmt/format.h>

namespace wiring {
namespace {

std::string escaped(const std::string& text) {
  std::string words;
  for (const char c : text) {
    if (c == '&') {
      words += "&amp;";
    } else if (c == '<') {
      words += "&lt;";
    } else if (c == '>') {
      words += "&gt;";
    } else {
      words += c;
    }
  }
  return words;
}

const char* name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return "start";
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
  }
  return "";
}

}  // namespace

std::string Drawing::points_of(const std::vector<Place>& points) const {
  std::string text;
  for (const Place& point : points) {
    text += fmt::format("{}{:g},{:g}", text.empty() ? "" : " ", x(point.x), y(point.y));
  }
  return text;
}

void Drawing::line(const std::vector<Place>& points, const std::string& color, double width) {
  body_ +=
      fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\"/>\n",
                  points_of(points), color, width);
}

void Drawing::polygon(const std::vector<Place>& points, const std::string& fill) {
  body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"#222\"/>\n", points_of(points),
                       fill);
}

void Drawing::rectangle(Place corner, Place size, const std::string& fill,
                        const std::string& color) {
  body_ += fmt::format(
      "<rect x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" fill=\"{}\" stroke=\"{}\"/>\n",
      x(corner.x), y(corner.y), size.x * pixels_, size.y * pixels_, fill, color);
}

void Drawing::circle(Place center, double radius, const std::string& fill,
                     const std::string& color) {
  body_ += fmt::format("<circle cx=\"{:g}\" cy=\"{:g}\" r=\"{:g}\" fill=\"{}\" stroke=\"{}\"/>\n",
                       x(center.x), y(center.y), radius * pixels_, fill, color);
}

void Drawing::text(Place at, const std::string& words, const Label& label) {
  body_ += fmt::format(
      "<text x=\"{:g}\" y=\"{:g}\" text-anchor=\"{}\" font-size=\"{:g}\"{} fill=\"{}\">{}</text>\n",
      x(at.x), y(at.y), name_of(label.anchor), label.size,
      label.is_bold ? " font-weight=\"bold\"" : "", label.color, escaped(words));
}

std::string Drawing::svg(const std::string& title) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
      "height=\"{1:g}\" font-family=\"DejaVu Sans Mono, monospace\">\n"
      "<title>{2}</title>\n<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"white\"/>\n{3}</svg>\n",
      width_ * pixels_, height_ * pixels_, escaped(title), body_);
}

}  // namespace wiring
