// SPDX-License-Identifier: Apache-2.0
// Buffered writing of edges.
#include "sim/report/edge_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace report {

namespace {
constexpr std::string_view axis_names = "xyze";

[[noreturn]] void fail(fmt::format_string<std::string, std::string> text,
                       const std::filesystem::path& file, int error) {
  throw std::runtime_error(
      fmt::format(text, file.string(), std::generic_category().message(error)));
}

}  // namespace

EdgeFile::EdgeFile(const std::filesystem::path& file)
    : path_(file), file_(std::fopen(file.c_str(), "w")) {
  if (!file_) {
    fail("cannot write {}: {}", file, errno);
  }
  // Written at once: a full disk is noticed before the job.
  if (std::fputs("cycle,axis,direction,position\n", file_.get()) < 0 ||
      std::fflush(file_.get()) != 0) {
    fail("cannot write {}: {}", file, errno);
  }
}

void EdgeFile::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= axis_names.size()) {
    return;
  }
  fmt::memory_buffer row;
  fmt::format_to(std::back_inserter(row), "{},{},{},{}\n", edge.clock, axis_names[edge.axis],
                 edge.direction, edge.position);
  if (std::fwrite(row.data(), 1, row.size(), file_.get()) != row.size() && error_ == 0) {
    error_ = errno;
  }
}

void EdgeFile::close() {
  if (std::fclose(file_.release()) != 0 && error_ == 0) {
    error_ = errno;
  }
  if (failed()) {
    fail("cannot write all of {}: {}", path_, error_);
  }
}

}  // namespace report
