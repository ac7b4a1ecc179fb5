// SPDX-License-Identifier: Apache-2.0
// A peripheral's registers as its description file gives them, checked and with offsets settled.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace register_generator {

enum class Access { read, write, read_write, external };
enum class FieldType { bit, unsigned_number, signed_number, bits };

struct Field {
  std::string name;
  unsigned msb{};
  unsigned lsb{};
  FieldType type{};
  std::uint32_t reset{};
  std::vector<std::pair<std::string, std::uint32_t>> values;
  std::string summary;

  unsigned width() const { return msb - lsb + 1; }
  bool is_enumeration() const { return !values.empty(); }
  std::uint32_t mask() const { return width() == 32 ? 0xFFFF'FFFFu : ((1u << width()) - 1u); }
};

struct Register {
  std::string name;
  Access access{};
  unsigned offset{};
  unsigned count{1};
  bool is_array{};
  bool read_event{};
  bool write_event{};
  std::string summary;
  std::vector<Field> fields;

  bool readable() const { return access != Access::write; }
  bool writable() const { return access != Access::read; }
  bool stored() const { return access == Access::read_write; }
  // Software -> hardware: the value; and the pulse that says it was written.
  bool value_from_software() const { return writable(); }
  bool has_written() const {
    return access == Access::write || access == Access::external || write_event;
  }
  bool value_to_software() const { return access == Access::read || access == Access::external; }
};

// A value of 64 bits in two registers, NAME_low and NAME_high, which follow each other.
struct WideRegister {
  std::string name;
  std::string summary;
  // Of the value, and of each half of it.
  std::string field;
  bool is_signed{};
};

// A number that hardware and software share.
struct Constant {
  std::string name;
  std::uint32_t value{};
  std::string summary;
};

// A bit of the processor's interrupt registers, and what it means.
struct Interrupt {
  std::string name;
  unsigned number{};
  std::string summary;
  std::string peripheral;
};

struct Peripheral {
  std::string name;
  std::uint32_t address{};
  std::string summary;
  std::vector<Register> registers;
  std::vector<WideRegister> wide_registers;
  std::vector<Constant> constants;
  std::vector<Interrupt> interrupts;

  bool has_from_software() const;
  bool has_to_software() const;
};

// What is wrong with a description file, naming the file and the place in it.
class DescriptionError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Reads and checks a description file with those that it includes. Throws DescriptionError.
Peripheral load(const std::filesystem::path& file);

// The description files (.toml) in a folder and those in it, but for those that others include.
std::vector<std::filesystem::path> description_files(const std::filesystem::path& folder);

std::string vhdl_package(const Peripheral& peripheral, const std::string& source);
std::string vhdl_registers(const Peripheral& peripheral, const std::string& source);
std::string cpp_file(const Peripheral& peripheral, const std::string& source);
std::string markdown_file(const Peripheral& peripheral, const std::string& source);

// The interrupts of all peripherals, in the order of their numbers. Throws DescriptionError where
// two share a name or a number.
std::vector<Interrupt> interrupts_of(const std::vector<Peripheral>& peripherals);

std::string vhdl_interrupts(const std::vector<Interrupt>& interrupts);
std::string cpp_interrupts(const std::vector<Interrupt>& interrupts);
std::string markdown_interrupts(const std::vector<Interrupt>& interrupts);

}  // namespace register_generator
