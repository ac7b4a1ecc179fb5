// SPDX-License-Identifier: Apache-2.0
// The project's decoder and objdump find the same instructions in the whole firmware.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <string>

#include "directories.hpp"
#include "sim/processor/decoder.hpp"
#include "tools/process/process.hpp"
#include "tools/timing/costs.hpp"
#include "tools/timing/program.hpp"

namespace timing {
namespace {

std::string kind_of(processor::Operation operation) {
  using enum processor::Operation;
  if (is_load(operation)) return "load";
  if (is_store(operation)) return "store";
  if (is_branch(operation)) return "branch";
  if (operation == jump) return "jump";
  if (operation == jump_register) return "jump_register";
  if (operation == divide) return "divide";
  if (operation >= multiply && operation <= multiply_high_unsigned) return "multiply";
  if (operation == csr) return "csr";
  if (operation == illegal) return "illegal";
  return "other";
}

std::string kind_of(std::string name) {
  if (name.starts_with("c.")) name = name.substr(2);
  if (name == "lui" || name == "li") return "other";
  if (name.starts_with("csr")) return "csr";
  if (name.starts_with("mul")) return "multiply";
  if (name.starts_with("div") || name.starts_with("rem")) return "divide";
  if (name == "jalr" || name == "jr") return "jump_register";
  if (name == "jal" || name == "j") return "jump";
  if (name[0] == 'b') return "branch";
  if (name[0] == 'l') return "load";
  if (name == "sw" || name == "sh" || name == "sb" || name == "swsp") return "store";
  if (name == "unimp" || name.starts_with(".")) return "illegal";
  return "other";
}

TEST(Decoder, finds_what_objdump_finds_in_the_whole_firmware) {
  const std::string file = BUILD_DIRECTORY "/firmware/firmware.elf";
  const Program program = read_program(file);
  const auto dump = process::capture({.arguments = {"riscv64-unknown-elf-objdump", "-d", "-j",
                                                    ".text", "-M", "no-aliases", file}});
  ASSERT_EQ(dump.exit_status, 0) << dump.output;
  std::istringstream lines(dump.output);
  std::size_t count = 0;
  std::string line;
  while (std::getline(lines, line)) {
    unsigned address = 0;
    std::array<char, 16> digits{}, name{};
    std::array<char, 200> operands{};
    if (std::sscanf(line.c_str(), "%x: %15s %15s %199s", &address, digits.data(), name.data(),
                    operands.data()) < 3 ||
        !program.is_code(address)) {
      continue;
    }
    const auto found = processor::decode(program.word_at(address), address, false);
    ASSERT_EQ(found.bytes * 2U, std::string(digits.data()).size()) << line;
    ASSERT_EQ(kind_of(found.operation), kind_of(std::string(name.data()))) << line;
    if (is_branch(found.operation) || found.operation == processor::Operation::jump) {
      const std::string text = operands.data();
      const auto comma = text.rfind(',');
      const std::string target = comma == std::string::npos ? text : text.substr(comma + 1);
      ASSERT_EQ(found.immediate, std::stoul(target, nullptr, 16)) << line;
    }
    ++count;
  }
  EXPECT_GT(count, 10'000U);
}

}  // namespace
}  // namespace timing
