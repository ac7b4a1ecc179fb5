// SPDX-License-Identifier: Apache-2.0
// The project's decoder and objdump find the same instructions in the whole firmware.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <optional>
#include <set>
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

// x1 to x31 as objdump names them in the operands.
std::set<unsigned> registers_in(const std::string& name, const std::string& operands) {
  std::set<unsigned> registers;
  for (std::size_t at = operands.find('x'); at != std::string::npos;
       at = operands.find('x', at + 1)) {
    if (at != 0 && operands[at - 1] == '0') {
      continue;  // 0x1f
    }
    registers.insert(static_cast<unsigned>(std::stoul(operands.substr(at + 1))));
  }
  if (name == "c.jal" || name == "c.jalr") registers.insert(1);
  registers.erase(0);
  return registers;
}

std::set<unsigned> registers_of(const processor::Instruction& instruction) {
  std::set<unsigned> registers{instruction.first, instruction.second};
  if (instruction.destination != processor::no_register) registers.insert(instruction.destination);
  registers.erase(0);
  return registers;
}

// The last operand, or the distance in "8(x2)"; nothing where it is a register.
std::optional<std::uint32_t> number_in(const std::string& operands) {
  const std::string last = operands.substr(operands.rfind(',') + 1);
  if (last.empty() || last[0] == 'x') return std::nullopt;
  return static_cast<std::uint32_t>(std::stoll(last, nullptr, 0));
}

bool is_of_system(const std::string& name) {
  return name.starts_with("csr") || name.starts_with("fence") || name == "wfi" || name == "mret" ||
         name == "ecall" || name == "ebreak" || name == "c.ebreak";
}

// Registers, and numbers but for the targets of branches and jumps.
void expect_operands(const processor::Instruction& found, std::uint32_t address,
                     const std::string& name, const std::string& operands) {
  using enum processor::Operation;
  if (is_of_system(name) || kind_of(name) == "illegal") return;
  EXPECT_EQ(registers_of(found), registers_in(name, operands));
  const auto number = number_in(operands);
  if (!number || is_branch(found.operation) || found.operation == jump) return;
  if (name == "auipc") {
    EXPECT_EQ(found.immediate, address + (*number << 12));
  } else if (found.operation == constant) {
    EXPECT_EQ(found.immediate, *number << 12);
  } else {
    EXPECT_EQ(found.immediate, *number);
  }
}

TEST(Decoder, finds_what_objdump_finds_in_the_whole_firmware) {
  const std::string file = BUILD_DIRECTORY "/firmware/firmware.elf";
  const Program program = read_program(file);
  const auto dump = process::capture({.arguments = {"riscv64-unknown-elf-objdump", "-d", "-j",
                                                    ".text", "-M", "no-aliases,numeric", file}});
  ASSERT_EQ(dump.exit_status, 0) << dump.output;
  std::istringstream lines(dump.output);
  std::size_t count = 0;
  Address next = program.first;
  // Zeros that align what follows, which objdump leaves out.
  const auto skip_to = [&](Address end) {
    for (; next < end; ++next) ASSERT_EQ(program.bytes.at(next - program.first), 0) << next;
  };
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
    expect_operands(found, address, name.data(), operands.data());
    ASSERT_FALSE(HasFailure()) << line;
    ++count;
    skip_to(address);
    next += found.bytes;
  }
  skip_to(program.code_end);
  EXPECT_GT(count, 10'000U);
  EXPECT_EQ(next, program.code_end);
}

}  // namespace
}  // namespace timing
