// SPDX-License-Identifier: Apache-2.0
// Writing and reading paths.
#include "tools/planning/path_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

namespace planning {

namespace {

using Json = nlohmann::json;
constexpr std::string_view magic = "SFPATH1\n";
constexpr std::size_t length_bytes = 4;
constexpr std::uint32_t longest_head = 64u << 20u;
constexpr double finest_unit_mm = 0.01;

void put(std::string& text, std::uint32_t value, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xFFu);
}

// So coarse that the farthest point has a number of 16 bits.
double unit_of(const Path& path) {
  double farthest = 0;
  for (const PathPoint& point : path.points) {
    farthest = std::max<double>({farthest, std::abs(point.x_mm), std::abs(point.y_mm)});
  }
  return std::max(finest_unit_mm, farthest / std::numeric_limits<std::int16_t>::max());
}

Json bounds_of(const Path& path) {
  std::optional<std::array<float, 4>> bounds;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    if (!path.points[i].extrudes) continue;
    for (const PathPoint& point : {path.points[i - 1], path.points[i]}) {
      if (!bounds) bounds = {point.x_mm, point.y_mm, point.x_mm, point.y_mm};
      auto& [left, low, right, high] = *bounds;
      left = std::min(left, point.x_mm);
      low = std::min(low, point.y_mm);
      right = std::max(right, point.x_mm);
      high = std::max(high, point.y_mm);
    }
  }
  return bounds ? Json(*bounds) : Json();
}

// So many more; memory is taken only for what is there.
std::string read_bytes(std::ifstream& stream, std::size_t count) {
  const std::streamoff here = stream.tellg();
  const std::streamoff end = stream.seekg(0, std::ios::end).tellg();
  if (!stream.seekg(here) || end - here < static_cast<std::streamoff>(count)) {
    throw std::runtime_error("the file of the path is damaged");
  }
  std::string bytes(count, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  if (!stream) throw std::runtime_error("the file of the path is damaged");
  return bytes;
}

std::string read_head(std::ifstream& stream) {
  if (read_bytes(stream, magic.size()) != magic) throw std::runtime_error("it is no path");
  std::uint32_t length = 0;
  const std::string bytes = read_bytes(stream, length_bytes);
  for (std::size_t i = length_bytes; i-- > 0;) {
    length = length << 8u | static_cast<unsigned char>(bytes[i]);
  }
  if (length > longest_head) throw std::runtime_error("the file of the path is damaged");
  return read_bytes(stream, length);
}

}  // namespace

std::string path_file_of(const Path& path) {
  const double unit = unit_of(path);
  Json head{{"unit_mm", unit},
            {"steps_per_mm", path.steps_per_mm},
            {"bounds_mm", bounds_of(path)},
            {"layers", Json::array()}};
  for (std::size_t i = 0; i < path.layers.size(); ++i) {
    const std::size_t first = path.layers[i].first;
    const std::size_t end =
        i + 1 < path.layers.size() ? path.layers[i + 1].first : path.points.size();
    head["layers"].push_back(
        {std::round(path.layers[i].z_mm * 1000) / 1000, end - first, path.points[first].command});
  }
  const std::string text = head.dump();
  std::string file(magic);
  file.reserve(magic.size() + length_bytes + text.size() + path.points.size() * path_point_bytes);
  put(file, static_cast<std::uint32_t>(text.size()), length_bytes);
  file += text;
  for (const PathPoint& point : path.points) {
    for (const float mm : {point.x_mm, point.y_mm}) {
      put(file, static_cast<std::uint32_t>(std::lround(mm / unit)), 2);
    }
    put(file, point.command << 1u | (point.extrudes ? 1u : 0u), 4);
  }
  return file;
}

std::string read_path_head(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return read_head(stream);
}

std::optional<std::string> read_path_layer(const std::filesystem::path& file, std::size_t layer) {
  std::ifstream stream(file, std::ios::binary);
  const std::string head = read_head(stream);
  std::size_t before = 0, count = 0;
  try {
    const Json layers = Json::parse(head).at("layers");
    if (layer >= layers.size()) return std::nullopt;
    for (std::size_t i = 0; i < layer; ++i) before += layers[i].at(1).get<std::uint32_t>();
    count = layers[layer].at(1).get<std::uint32_t>();
  } catch (const Json::exception&) {
    throw std::runtime_error("the file of the path is damaged");
  }
  stream.seekg(static_cast<std::streamoff>(before * path_point_bytes), std::ios::cur);
  return read_bytes(stream, count * path_point_bytes);
}

}  // namespace planning
