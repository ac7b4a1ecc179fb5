// SPDX-License-Identifier: Apache-2.0
// The path of short files: points, layers, commands; its file; its picture.
#include <gmock/gmock.h>
#include <png.h>

#include <cstring>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "tools/planning/path_file.hpp"
#include "tools/planning/picture.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

using testing::ElementsAre;

Path path_of(std::initializer_list<std::string_view> lines) {
  PrintPlanner planner(50'000'000);
  PathRecorder recorder;
  planner.on_line([&recorder](const Walk& walk) { recorder.add(walk); });
  std::uint32_t number = 0;
  for (const std::string_view line : lines) {
    recorder.begin_command(++number);
    planner.take(number, line);
    recorder.end_command(planner.planned_lines());
  }
  planner.finish();
  return recorder.finish(planner.steps_per_mm());
}

MATCHER_P4(is_point, x, y, command, extrudes, "") {
  return std::abs(double{arg.x_mm} - x) < 0.01 && std::abs(double{arg.y_mm} - y) < 0.01 &&
         std::cmp_equal(arg.command, command) && arg.extrudes == extrudes;
}

TEST(path, names_the_command_of_each_line_though_it_is_planned_ahead) {
  const Path path = path_of({"M83", "G1 Z0.2 F600", "G0 X10 Y5 F6000", "M105", "G1 X20 E1 F1800",
                             "G1 Y15 E1", "G1 X10 E-1", "G1 X0"});
  EXPECT_THAT(path.points, ElementsAre(is_point(0, 0, 2, false), is_point(10, 5, 3, false),
                                       is_point(20, 5, 5, true), is_point(20, 15, 6, true),
                                       is_point(0, 15, 8, false)));
  ASSERT_EQ(path.layers.size(), 1u);
  EXPECT_NEAR(path.layers[0].z_mm, 0.2, 1e-6);
}

// More lines than the planner and the step generator hold together.
TEST(path, names_the_commands_of_a_long_file) {
  PrintPlanner planner(50'000'000);
  PathRecorder recorder;
  planner.on_line([&recorder](const Walk& walk) { recorder.add(walk); });
  for (std::uint32_t i = 1; i <= 500; ++i) {
    recorder.begin_command(i);
    planner.take(i, "G1 X" + std::to_string(i) + " Y" + std::to_string(i % 2) + " F6000");
    recorder.end_command(planner.planned_lines());
  }
  planner.finish();
  const Path path = recorder.finish(planner.steps_per_mm());
  ASSERT_EQ(path.points.size(), 501u);
  for (std::uint32_t i = 1; i <= 500; ++i) {
    ASSERT_THAT(path.points[i],
                is_point(static_cast<float>(i), static_cast<float>(i % 2), i, false));
  }
}

TEST(path, has_a_layer_for_each_height_that_is_extruded_at_and_each_rise_of_a_vase) {
  const Path flat = path_of({"M83", "G1 Z0.3 F600", "G1 X10 E1", "G1 Z1", "G1 X0 Y0", "G1 Z0.6",
                             "G1 X10 E1", "G1 Y10 E1"});
  ASSERT_EQ(flat.layers.size(), 2u);
  EXPECT_NEAR(flat.layers[0].z_mm, 0.3, 1e-6);
  EXPECT_NEAR(flat.layers[1].z_mm, 0.6, 1e-6);
  EXPECT_THAT(flat.points[flat.layers[1].first], is_point(0, 0, 7, false));  // where it begins
  const Path vase = path_of({"M83", "G1 Z0.2 F600", "G1 X10 E1", "G1 X0 Z0.3 E1", "G1 X10 Z0.41 E1",
                             "G1 X0 Z0.5 E1", "G1 X10 Z0.7 E1"});
  EXPECT_EQ(vase.layers.size(), 3u);
}

TEST(path, leaves_out_points_on_a_straight_line_and_no_others) {
  const Path path = path_of({"M83", "G1 X10 E1 F1800", "G1 X20 E1", "G1 X30 Y0.01 E1",
                             "G1 X40 Y1 E1", "G1 X50 Y2", "G1 X40 Y1"});
  EXPECT_THAT(path.points, ElementsAre(is_point(0, 0, 2, false), is_point(30, 0.01, 4, true),
                                       is_point(40, 1, 5, true), is_point(50, 2, 6, false),
                                       is_point(40, 1, 7, false)));
}

TEST(path_file, gives_each_layer_as_it_was_written) {
  const TemporaryFolder folder;
  const Path path = path_of({"M83", "G1 Z0.2 F600", "G1 X10 E1", "G1 Z0.4", "G1 X-400 Y7.25 E1"});
  folder.write("path", path_file_of(path));
  const auto head = nlohmann::json::parse(read_path_head(folder.path() / "path"));
  const double unit = head.at("unit_mm");
  EXPECT_EQ(head.at("layers"), nlohmann::json::parse("[[0.2, 2, 2], [0.4, 2, 5]]"));
  EXPECT_EQ(head.at("bounds_mm"), nlohmann::json::parse("[-400.0, 0.0, 10.0, 7.25]"));
  EXPECT_EQ(head.at("steps_per_mm").at(0), 80);
  const auto layer = read_path_layer(folder.path() / "path", 1);
  ASSERT_TRUE(layer && layer->size() == 2 * path_point_bytes);
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = bytes; i-- > 0;) {
      value = value << 8u | static_cast<unsigned char>((*layer)[at + i]);
    }
    return value;
  };
  EXPECT_NEAR(static_cast<std::int16_t>(number(8, 2)) * unit, -400, unit);
  EXPECT_NEAR(static_cast<std::int16_t>(number(10, 2)) * unit, 7.25, unit);
  EXPECT_EQ(number(12, 4), 5u << 1u | 1u);
  EXPECT_FALSE(read_path_layer(folder.path() / "path", 2));
}

TEST(path_file, is_refused_where_it_is_cut_damaged_or_no_path) {
  const TemporaryFolder folder;
  const std::string file =
      path_file_of(path_of({"M83", "G1 Z0.2 F600", "G1 X10 E1", "G1 Z0.4", "G1 Y7.25 E1"}));
  folder.write("short", file.substr(0, file.size() - 1));
  EXPECT_EQ(read_path_layer(folder.path() / "short", 0)->size(), 2 * path_point_bytes);
  EXPECT_THROW(read_path_layer(folder.path() / "short", 1), std::runtime_error);
  for (const char* head : {"[]", "{}", R"({"layers":[[0.2]]})", R"({"layers":[[0.2,"x",2]]})",
                           R"({"layers":[[0.2,4000000000,2]]})"}) {
    folder.write("damaged", std::string("SFPATH1\n") + static_cast<char>(std::strlen(head)) +
                                std::string(3, '\0') + head);
    EXPECT_THROW(read_path_layer(folder.path() / "damaged", 0), std::runtime_error) << head;
  }
  folder.write("other", "G1 X10\nG1 X20\nG1 X10\n");
  EXPECT_THROW(read_path_head(folder.path() / "other"), std::runtime_error);
  EXPECT_THROW(read_path_head(folder.path() / "missing"), std::runtime_error);
}

// Points of a PNG of the size of pictures, four bytes each: red, green, blue, alpha.
std::vector<png_byte> pixels_of(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, png.data(), png.size())) << image.message;
  EXPECT_EQ(image.width, png_uint_32{picture_pixels});
  EXPECT_EQ(image.height, png_uint_32{picture_pixels});
  EXPECT_EQ(image.format, png_uint_32{PNG_FORMAT_RGBA});
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr)) << image.message;
  return pixels;
}

TEST(picture, shows_what_is_extruded_on_a_transparent_ground) {
  EXPECT_EQ(picture_of(path_of({"G1 X10 F600", "G1 Y10"})), "");
  const std::vector<png_byte> pixels =
      pixels_of(picture_of(path_of({"M83", "G1 Z0.2 F600", "G1 X10 E1", "G1 Y10 E1"})));
  ASSERT_EQ(pixels.size(), std::size_t{4} * picture_pixels * picture_pixels);
  int painted = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    const png_byte alpha = pixels[i + 3];
    EXPECT_TRUE(alpha == 0 || alpha == 255) << i;
    if (alpha == 255) ++painted;
  }
  // Two lines, seen at an angle: each goes over about half of the width.
  EXPECT_GT(painted, picture_pixels / 2);
  EXPECT_LT(painted, 2 * picture_pixels);
}

}  // namespace
}  // namespace planning
