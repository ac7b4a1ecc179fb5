// SPDX-License-Identifier: Apache-2.0
// Starts QEMU with its log on a pipe and reads the blocks that `-d cpu` writes.
#include "tests/processor/qemu_machine.hpp"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace processor {
namespace {

constexpr std::uint32_t first_address = 0x80000000;

// The number after a name such as " mepc     80000004".
std::uint32_t number_at(const char* text) {
  return static_cast<std::uint32_t>(std::strtoul(text, nullptr, 16));
}

}  // namespace

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
  process_.emplace(process::Start{
      .arguments = {"qemu-system-riscv32", "-machine", "virt", "-cpu",
                    has_zbb ? base + ",zbb=on" : base, "-m", "1M", "-bios", "none", "-display",
                    "none", "-monitor", "none", "-serial", "none", "-accel",
                    "tcg,one-insn-per-tb=on", "-device", loader, "-d", "cpu,nochain",
                    // As a file it is written line by line, otherwise number by number.
                    "-D", "/dev/stderr"},
      .to_pipe = true});
  log_ = fdopen(dup(process_->pipe()), "r");
}

QemuMachine::~QemuMachine() {
  process_->signal(SIGKILL);
  if (log_ != nullptr) std::fclose(log_);
  std::filesystem::remove(image_file_);
}

bool QemuMachine::read_line() {
  return std::fgets(line_.data(), static_cast<int>(line_.size()), log_) != nullptr;
}

std::optional<QemuState> QemuMachine::next() {
  QemuState state;
  while (read_line()) {
    const std::string_view line(line_.data());
    const char* const number = line_.data() + 10;
    if (line.starts_with(" pc ")) state.program_counter = number_at(number);
    if (line.starts_with(" mtvec ")) state.mtvec = number_at(number);
    if (line.starts_with(" mepc ")) state.mepc = number_at(number);
    if (line.starts_with(" mcause ")) state.mcause = number_at(number);
    if (line.starts_with(" mtval ")) state.mtval = number_at(number);
    if (line.starts_with(" mscratch ")) state.mscratch = number_at(number);
    if (!line.starts_with(" x")) continue;
    // Four of " x12/a2   00001028" in a line.
    const unsigned index = static_cast<unsigned>(std::strtoul(line_.data() + 2, nullptr, 10));
    for (unsigned column = 0; column < 4; ++column) {
      state.registers.at(index + column) = number_at(line_.data() + 10 + 18 * column);
    }
    // Before the program its loader runs.
    if (index == 28 && state.program_counter >= first_address) return state;
  }
  return std::nullopt;
}

}  // namespace processor
