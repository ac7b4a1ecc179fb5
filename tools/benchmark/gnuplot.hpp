// SPDX-License-Identifier: Apache-2.0
// Runs gnuplot on a script and takes its SVG.
#pragma once

#include <string>

namespace benchmarks {

struct PictureSize {
  int width{};
  int height{};
};

// `name` keeps the identifiers of several pictures on one page apart. Throws std::runtime_error
// with gnuplot's message.
std::string svg_of(const std::string& name, PictureSize size, const std::string& script);

}  // namespace benchmarks
