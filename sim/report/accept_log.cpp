// SPDX-License-Identifier: Apache-2.0
// Writes the rows of the accept log.
#include "sim/report/accept_log.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "tools/files/write_file.hpp"

namespace report {

std::string accept_log_row(const AcceptedLine& line) {
  std::string row = line.number ? fmt::format("{}\t", *line.number) : "-\t";
  for (const char character : line.text) {
    if (character >= ' ' && character <= '~') {
      row += character;
    } else {
      row += fmt::format("\\x{:02x}", static_cast<unsigned char>(character));
    }
  }
  return row + "\n";
}

AcceptLog::AcceptLog(const std::filesystem::path& file) : file_(file) {
  files::refuse_foreign_link(file);
  stream_.open(file, std::ios::binary);
  if (!stream_) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

void AcceptLog::put(const AcceptedLine& line) { stream_ << accept_log_row(line) << std::flush; }

void AcceptLog::close() {
  stream_.close();
  if (!stream_) throw std::runtime_error(fmt::format("cannot write all of {}", file_.string()));
}

}  // namespace report
