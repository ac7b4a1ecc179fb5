// SPDX-License-Identifier: Apache-2.0
// Layers from below to above, each over those before.
#include "tools/planning/picture.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace planning {

namespace {

constexpr double margin_pixels = 6;
// The view is turned by 45 degrees about Z and looks down by 30.
constexpr double diagonal = std::numbers::sqrt2 / 2, sine_of_tilt = 0.5, cosine_of_tilt = 0.866;

// As libpng's PNG_FORMAT_RGBA has it.
struct Pixel {
  png_byte red{}, green{}, blue{}, alpha{};
};

struct Place {
  double right{}, up{};
};

Place seen(double x, double y, double z) {
  return {.right = (x - y) * diagonal,
          .up = (x + y) * diagonal * sine_of_tilt + z * cosine_of_tilt};
}

struct Segment {
  Place from, to;
  double shade{};  // 0 dark to 1 light
};

// The direction of a line gives its light, as if it came from the left.
double shade_of(const PathPoint& from, const PathPoint& to, double part_of_height) {
  const double angle = std::atan2(to.y_mm - from.y_mm, to.x_mm - from.x_mm);
  return 0.35 + 0.35 * part_of_height + 0.3 * std::abs(std::sin(angle));
}

std::vector<Segment> segments_of(const Path& path) {
  std::vector<Segment> segments;
  const double top = path.layers.empty() ? 0 : std::max(path.layers.back().z_mm, 1e-3);
  for (std::size_t layer = 0; layer < path.layers.size(); ++layer) {
    const auto [z, first] = path.layers[layer];
    const std::size_t end =
        layer + 1 < path.layers.size() ? path.layers[layer + 1].first : path.points.size();
    for (std::size_t i = first + 1; i < end; ++i) {
      const PathPoint &from = path.points[i - 1], &to = path.points[i];
      if (!to.extrudes) continue;
      segments.push_back({.from = seen(from.x_mm, from.y_mm, z),
                          .to = seen(to.x_mm, to.y_mm, z),
                          .shade = shade_of(from, to, z / top)});
    }
  }
  return segments;
}

Pixel colour_of(double shade) {
  const auto mixed = [shade](int dark, int light) {
    return static_cast<png_byte>(std::lround(dark + (light - dark) * std::clamp(shade, 0.0, 1.0)));
  };
  return {.red = mixed(16, 120), .green = mixed(64, 190), .blue = mixed(128, 255), .alpha = 255};
}

std::string png_of(const std::vector<Pixel>& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = picture_pixels;
  image.format = PNG_FORMAT_RGBA;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("the picture cannot be written: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string picture_of(const Path& path) {
  const std::vector<Segment> segments = segments_of(path);
  if (segments.empty()) return {};
  constexpr double far = std::numeric_limits<double>::max();
  Place low{far, far}, high{-far, -far};
  for (const Segment& segment : segments) {
    for (const Place& place : {segment.from, segment.to}) {
      low = {std::min(low.right, place.right), std::min(low.up, place.up)};
      high = {std::max(high.right, place.right), std::max(high.up, place.up)};
    }
  }
  const double width = high.right - low.right, height = high.up - low.up;
  const double scale = (picture_pixels - 2 * margin_pixels) / std::max({width, height, 1e-3});
  const auto column = [&](double right) {
    return picture_pixels / 2.0 + (right - low.right - width / 2) * scale;
  };
  const auto row = [&](double up) {
    return picture_pixels / 2.0 - (up - low.up - height / 2) * scale;
  };
  std::vector<Pixel> pixels(std::size_t{picture_pixels} * picture_pixels);
  for (const Segment& segment : segments) {
    const double x = column(segment.from.right), y = row(segment.from.up);
    const double dx = column(segment.to.right) - x, dy = row(segment.to.up) - y;
    const int count = static_cast<int>(std::ceil(std::max({std::abs(dx), std::abs(dy), 1.0})));
    for (int i = 0; i <= count; ++i) {
      const double part = static_cast<double>(i) / count;
      const auto at = [](double value) {
        return static_cast<std::size_t>(
            std::clamp<long>(std::lround(value), 0, picture_pixels - 1));
      };
      pixels[at(y + dy * part) * picture_pixels + at(x + dx * part)] = colour_of(segment.shade);
    }
  }
  return png_of(pixels);
}

}  // namespace planning
