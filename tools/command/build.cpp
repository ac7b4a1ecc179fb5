// SPDX-License-Identifier: Apache-2.0
// Calls of cmake, one at a time per build folder.
#include "tools/command/build.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <stdexcept>

#include "machine_generator/description.hpp"
#include "machine_generator/header.hpp"
#include "machine_generator/kinematics_description.hpp"
#include "sim/processor/timing_table.hpp"
#include "tools/command/signals.hpp"
#include "tools/files/file_text.hpp"
#include "tools/files/write_file.hpp"
#include "tools/process/process.hpp"
#include "tools/timing/machine_schedule.hpp"
#include "tools/timing/stack.hpp"

namespace command {

namespace {

// A lock in the build folder, waited for.
class FolderLock {
 public:
  explicit FolderLock(const char* name)
      : file_(open((build_folder() / name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_ >= 0) flock(file_, LOCK_EX);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (file_ >= 0) close(file_);
  }

 private:
  int file_;
};

std::string last_lines(const std::filesystem::path& file, std::size_t count) {
  std::ifstream stream(file);
  std::deque<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

// What the linker leaves for the stack is proved to suffice for the machines of this project: how
// much more another one needs, or how much is left over (below 0). Throws std::runtime_error where
// its stack is not known.
std::int64_t missing_bytes(const std::filesystem::path& image,
                           const std::filesystem::path& description) {
  const timing::Program program = timing::read_program(image);
  const auto needed = timing::Stack(program, CHIP_HAS_ZBB).of_image();
  if (!needed) {
    throw std::runtime_error(
        fmt::format("{}: the firmware for this machine needs an unknown number of bytes of stack",
                    description.string()));
  }
  const std::int64_t left = std::int64_t{program.addresses.at("_stack_top")} -
                            std::int64_t{program.addresses.at("_stack_bottom")};
  // The linker wants so much of any image.
  const std::int64_t least = program.addresses.at("least_stack_bytes");
  return std::max<std::int64_t>(*needed, least) - left;
}

// Throws std::runtime_error where the main loop has no bound, or misses a deadline at the clock of
// its description.
void check_schedule(const std::filesystem::path& image, const std::filesystem::path& description,
                    const machine_generator::Machine& machine) {
  timing::Program program = timing::read_program(image);
  program.memory_bytes =
      std::max<std::uint32_t>(machine.memory_bytes.value_or(0), CHIP_MEMORY_BYTES);
  const auto schedule = timing::schedule_of(
      program, timing::Costs{processor::TimingTable()}, CHIP_HAS_ZBB,
      application::schedule_facts(machine.description.fast, machine.description.is_heavy()));
  const timing::Verdict verdict =
      timing::verdict_on(schedule, machine.whole(), machine.clock_hz, description.string());
  if (verdict.is_refused) throw std::runtime_error(verdict.text);
}

// As tools/machine_generator has it.
constexpr std::int64_t most_memory_kib = 256, memory_step_kib = 4;

[[noreturn]] void refuse_memory(const std::filesystem::path& description, std::int64_t needed_bytes,
                                std::uint32_t there_bytes) {
  const std::int64_t step = memory_step_kib * 1024;
  const std::int64_t kib = (needed_bytes + step - 1) / step * memory_step_kib;
  throw std::runtime_error(fmt::format(
      "{}: the firmware for this machine needs {} KiB of memory, and its chip has {}: {}",
      description.string(), kib, there_bytes / 1024,
      kib > most_memory_kib ? fmt::format("more than {} are not possible", most_memory_kib)
                            : fmt::format("set memory_kib = {} in the description", kib)));
}

// Whether the last build ended because the linker had too little memory.
bool lacked_memory() {
  const std::string log = files::text_of(build_folder() / "build.log");
  return log.find("the image is too large") != std::string::npos ||
         log.find("will not fit in region") != std::string::npos;
}

// The firmware for another machine than that of the build: none is built for a third one as
// long as this exists.
class OtherMachine {
 public:
  OtherMachine(const std::filesystem::path& description, const std::string& stepping) {
    const std::string header = stepping == "software"
                                   ? machine_generator::small_header_of(description)
                                   : machine_generator::header_of(description);
    const machine_generator::Machine machine = machine_generator::read_machine(description);
    tools_ = machine.description.tools();
    const bool two_tools = tools_ > 1;
    if (two_tools && stepping == "software") {
      throw std::runtime_error(fmt::format(
          "{}: with two extruders the step generator makes the steps: omit --stepping software",
          description.string()));
    }
    if (machine.description.limits.s_curve && stepping == "software") {
      throw std::runtime_error(fmt::format(
          "{}: ramps of third order need the step generator: omit --stepping software, or set "
          "motion.s_curve_acceleration = false",
          description.string()));
    }
    const std::string image_name =
        fmt::format("other_machine_{}_{}{}{}", stepping,
                    machine_generator::kinematics_name(machine.description.kinematics),
                    two_tools ? "_two_tools" : "",
                    machine.description.fast && stepping == "hardware" ? "_fast" : "");
    memory_bytes_ = std::max<std::uint32_t>(machine.memory_bytes.value_or(0), CHIP_MEMORY_BYTES);
    write_if_changed("machine/machine.hpp", header);
    link_for(memory_bytes_);
    file_ = build_folder() / "firmware" / (image_name + ".elf");
    const std::string target = "firmware_" + image_name;
    try {
      build({target});
    } catch (const std::runtime_error&) {
      if (stepping == "software" || !lacked_memory()) throw;
      // How much it needs is known once it is linked.
      constexpr std::uint32_t most_bytes = most_memory_kib * 1024;
      if (memory_bytes_ == most_bytes) refuse_memory(description, most_bytes + 1, most_bytes);
      link_for(most_bytes);
      build({target});
      refuse_memory(description, most_bytes + missing_bytes(file_, description), memory_bytes_);
    }
    const std::int64_t missing = missing_bytes(file_, description);
    if (missing <= 0) {
      if (stepping == "hardware") check_schedule(file_, description, machine);
      return;
    }
    // Of software stepping the memory is what the comparison has.
    if (stepping == "software") {
      throw std::runtime_error(
          fmt::format("{}: the firmware for this machine needs {} bytes of "
                      "memory more than there are",
                      description.string(), missing));
    }
    refuse_memory(description, memory_bytes_ + missing, memory_bytes_);
  }

  const std::filesystem::path& file() const { return file_; }
  std::uint32_t memory_bytes() const { return memory_bytes_; }
  std::size_t tools() const { return tools_; }
  sim::ElfImage image() const { return sim::read_elf(file_); }

 private:
  // The same text is not written again, so that nothing is built for it.
  static void write_if_changed(const char* name, const std::string& text) {
    const std::filesystem::path file = build_folder() / "generated" / "other_machine" / name;
    if (files::text_of(file) != text) files::write_file(file, text);
  }
  static void link_for(std::uint32_t memory_bytes) {
    write_if_changed("memory_options",
                     fmt::format("--defsym=chip_memory_bytes={}\n", memory_bytes));
  }

  FolderLock lock_{"other_machine_lock"};
  std::filesystem::path file_;
  std::uint32_t memory_bytes_{};
  std::size_t tools_{};
};

}  // namespace

std::filesystem::path project_folder() { return STEPFABRIC_PROJECT_FOLDER; }

std::filesystem::path build_folder() {
  const char* folder = std::getenv("STEPFABRIC_BUILD_DIR");
  return folder != nullptr && *folder != '\0' ? folder : STEPFABRIC_BUILD_FOLDER;
}

void build(const std::vector<std::string>& targets) {
  const FolderLock lock("lock");  // that tools/command/build_and_run.sh takes too
  const std::filesystem::path log = build_folder() / "build.log";
  std::vector<std::string> arguments{"cmake", "--build", build_folder().string(), "--target"};
  arguments.insert(arguments.end(), targets.begin(), targets.end());
  const process::Start start{.arguments = arguments, .output = log};
  if (process::run(start, {}, end_if_interrupted).exit_status != 0) {
    throw std::runtime_error(fmt::format("{}\nthe build of {} failed; the whole log is in {}",
                                         last_lines(log, 40), fmt::join(targets, ", "),
                                         log.string()));
  }
}

sim::ElfImage firmware_for(const std::filesystem::path& description, const std::string& stepping) {
  return OtherMachine(description, stepping).image();
}

std::uint32_t write_board_firmware(const std::filesystem::path& description,
                                   const std::filesystem::path& file) {
  const OtherMachine machine(description, "hardware");
  if (machine.tools() > 1) {
    throw std::runtime_error(
        fmt::format("{}: two hotends and a bed are three heaters, and the boards have two: omit "
                    "[tool_1]",
                    description.string()));
  }
  std::filesystem::create_directories(file.parent_path());
  std::filesystem::copy_file(machine.file(), file,
                             std::filesystem::copy_options::overwrite_existing);
  return machine.memory_bytes();
}

int run_program(const std::vector<std::string>& arguments) {
  return process::run({.arguments = arguments}, {}, end_if_interrupted).exit_status;
}

}  // namespace command
