// SPDX-License-Identifier: Apache-2.0
// Buffered writing of edges.
#include "sim/report/edge_file.hpp"

#include <fmt/format.h>

#include <iterator>
#include <stdexcept>
#include <string_view>

namespace report {

namespace {
constexpr std::string_view axis_names = "xyze";
}

EdgeFile::EdgeFile(const std::filesystem::path& file)
    : path_(file), file_(std::fopen(file.c_str(), "w")) {
  if (!file_) {
    throw std::runtime_error(fmt::format("cannot write {}", file.string()));
  }
  std::fputs("cycle,axis,direction,position\n", file_.get());
}

void EdgeFile::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= axis_names.size()) {
    return;
  }
  fmt::memory_buffer row;
  fmt::format_to(std::back_inserter(row), "{},{},{},{}\n", edge.clock, axis_names[edge.axis],
                 edge.direction, edge.position);
  std::fwrite(row.data(), 1, row.size(), file_.get());
}

void EdgeFile::close() {
  const bool written = std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0;
  file_.reset();
  if (!written) {
    throw std::runtime_error(fmt::format("cannot write all of {}", path_.string()));
  }
}

}  // namespace report
