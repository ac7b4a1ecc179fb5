// SPDX-License-Identifier: Apache-2.0
// Starts QEMU with the plugin, whose records come through a pipe.
#include "tests/processor/qemu_machine.hpp"

#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace processor {

QemuMachine::QemuMachine(const std::vector<std::uint8_t>& image, bool has_zbb) {
  std::string name = (std::filesystem::temp_directory_path() / "stepfabric_qemu_XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0) throw std::runtime_error("cannot make " + name);
  close(file);
  image_file_ = name;
  std::ofstream(image_file_, std::ios::binary)
      .write(reinterpret_cast<const char*>(image.data()),
             static_cast<std::streamsize>(image.size()));

  const std::string loader = "loader,file=" + name + ",addr=0x80000000,force-raw=on";
  const std::string base = "rv32i,m=on,c=on,zicsr=on,zifencei=on";
  process_.emplace(process::Start{.arguments = {"qemu-system-riscv32",
                                                "-machine",
                                                "virt",
                                                "-cpu",
                                                has_zbb ? base + ",zbb=on" : base,
                                                "-m",
                                                "1M",
                                                "-bios",
                                                "none",
                                                "-display",
                                                "none",
                                                "-monitor",
                                                "none",
                                                "-serial",
                                                "none",
                                                "-accel",
                                                "tcg",
                                                "-device",
                                                loader,
                                                "-plugin",
                                                QEMU_PLUGIN},
                                  .to_pipe = true});
  records_ = fdopen(dup(process_->pipe()), "r");
  find_first_record();
}

QemuMachine::~QemuMachine() {
  process_->signal(SIGKILL);
  if (records_ != nullptr) std::fclose(records_);
  std::filesystem::remove(image_file_);
}

void QemuMachine::find_first_record() {
  std::string text;
  const std::uint32_t mark = QemuRecord::mark;
  const std::string_view wanted(reinterpret_cast<const char*>(&mark), sizeof mark);
  while (!text.ends_with(wanted)) {
    const int next = std::fgetc(records_);
    if (next == EOF) throw std::runtime_error("QEMU does not run: " + text);
    text += static_cast<char>(next);
  }
  for (auto byte = wanted.rbegin(); byte != wanted.rend(); ++byte) std::ungetc(*byte, records_);
}

std::optional<QemuRecord> QemuMachine::next() {
  QemuRecord record;
  if (std::fread(&record, sizeof record, 1, records_) != 1) return std::nullopt;
  if (record.begin != QemuRecord::mark) throw std::runtime_error("QEMU writes other text");
  return record;
}

}  // namespace processor
