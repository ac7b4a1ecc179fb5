// SPDX-License-Identifier: Apache-2.0
// Calling gnuplot as a program, with the script and its messages in a folder of their own.
#include "tools/benchmark/gnuplot.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace benchmarks {

namespace {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "stepfabric-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error("cannot make a temporary folder for gnuplot");
    }
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::string svg_of(const std::string& name, PictureSize size, const std::string& script) {
  const TemporaryFolder folder;
  const std::filesystem::path script_file = folder / "script", picture = folder / "picture.svg",
                              messages = folder / "messages";
  std::ofstream(script_file) << fmt::format(
      "set terminal svg size {},{} dynamic enhanced name \"{}\" "
      "font \"Lato,DejaVu Sans,sans-serif,14\" background \"#ffffff\"\n"
      "set output \"{}\"\n{}",
      size.width, size.height, name, picture.string(), script);
  const process::Start gnuplot{.arguments = {"gnuplot", script_file.string()}, .output = messages};
  if (process::run(gnuplot).exit_status != 0) {
    throw std::runtime_error(fmt::format("gnuplot failed: {}", files::text_of(messages)));
  }
  const std::string svg = files::text_of(picture);
  const std::size_t begin = svg.find("<svg");
  if (begin == std::string::npos) {
    throw std::runtime_error(fmt::format("gnuplot drew nothing: {}", files::text_of(messages)));
  }
  return svg.substr(begin);
}

}  // namespace benchmarks
