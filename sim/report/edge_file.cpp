// SPDX-License-Identifier: Apache-2.0
// Rows are gathered and written some hundred at a time.
#include "sim/report/edge_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "tools/files/write_file.hpp"

namespace report {

namespace {
constexpr std::array<std::string_view, 5> axis_names{"x", "y", "z", "e", "e1"};
// Of rows that wait to be written together.
constexpr std::size_t most_waiting_bytes = 4000;

[[noreturn]] void fail(fmt::format_string<std::string, std::string> text,
                       const std::filesystem::path& file, int error) {
  throw std::runtime_error(
      fmt::format(text, file.string(), std::generic_category().message(error)));
}

std::FILE* open_to_write(const std::filesystem::path& file) {
  files::refuse_foreign_link(file);
  return std::fopen(file.c_str(), "w");
}

}  // namespace

EdgeFile::EdgeFile(const std::filesystem::path& file) : path_(file), file_(open_to_write(file)) {
  if (!file_) fail("cannot write {}: {}", file, errno);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
  // A full disk is noticed before the job.
  rows_ = "cycle,axis,direction,position\n";
  flush();
  if (failed()) fail("cannot write {}: {}", file, error_);
}

void EdgeFile::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= axis_names.size()) return;
  fmt::format_to(std::back_inserter(rows_), "{},{},{},{}\n", edge.clock, axis_names[edge.axis],
                 edge.direction, edge.position);
  if (rows_.size() >= most_waiting_bytes) flush();
}

void EdgeFile::flush() {
  if (file_ && std::fwrite(rows_.data(), 1, rows_.size(), file_.get()) != rows_.size() &&
      error_ == 0) {
    error_ = errno;
  }
  rows_.clear();
}

void EdgeFile::close() {
  flush();
  if (std::fclose(file_.release()) != 0 && error_ == 0) error_ = errno;
  if (failed()) fail("cannot write all of {}: {}", path_, error_);
}

}  // namespace report
