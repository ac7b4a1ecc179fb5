// SPDX-License-Identifier: Apache-2.0
// An image for the chip as the analysis sees it: code, constants, functions, loop bounds, lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace timing {

using Address = std::uint32_t;

// What `LoopBound<most, tag>` leaves in the image (firmware/units/loop_bound.hpp): the place of a
// call of next(), or of the end of the object.
struct LoopMarker {
  Address address{};
  std::uint32_t most{};  // calls in the life of the object
  std::uint32_t tag{};
  std::uint32_t is_end{};
};

// What `declare_call_by<table>()` leaves in the image (firmware/units/call_table.hpp): its place,
// and the table.
struct CallTable {
  Address place{}, first{}, bytes{};
};

// What `happens<event>()` and `EventBound<event, most>` leave in the image, in the order of its
// code (firmware/units/event_bound.hpp).
struct EventMarker {
  enum Kind : std::uint32_t { event_happens, begin, end };
  Address address{};
  std::uint32_t event{}, most{};
  std::uint32_t kind{};
};

// What `TaskSpan<task>` leaves in the image (firmware/units/task_span.hpp).
struct TaskMarker {
  Address address{};
  std::uint32_t task{};
  std::uint32_t is_end{};
};

struct Symbol {
  std::string name;  // demangled, without its arguments
  Address size{};
};

// Source lines by address.
class Lines;

struct Program {
  // Bytes that nothing writes: code and constants.
  Address first{};
  std::vector<std::uint8_t> bytes;
  Address code_end{};
  std::map<Address, Symbol> symbols;  // of code
  std::map<std::string, Address> addresses;  // of all symbols, by their names as in the file
  std::vector<LoopMarker> markers;
  std::vector<CallTable> call_tables;
  std::vector<EventMarker> event_markers;
  std::vector<TaskMarker> task_markers;
  // The functions with an access of the bus: in them alone an address that is not known may be a
  // peripheral's. Nothing where the image does not say: in all.
  std::optional<std::set<Address>> functions_on_bus;
  // Memory that answers at once; all else is on the bus.
  Address memory_start = 0x8000'0000;
  Address memory_bytes{};
  std::shared_ptr<const Lines> lines;

  bool is_code(Address address) const { return address >= first && address < code_end; }
  // 32 bits at any half word; of the last half word the upper half is 0.
  std::uint32_t word_at(Address address) const;
  // What a load of so many bytes finds, without its sign; nothing where it may change.
  std::optional<std::uint32_t> constant_at(Address address, unsigned size) const;
  bool in_memory(Address address) const { return address - memory_start < memory_bytes; }

  // Of a symbol at this address, or the one before it.
  std::string name_of(Address address) const;
  // Where the function begins in which it lies.
  Address function_at(Address address) const;
  // "firmware/drivers/uart.cpp:42", or the address where the image does not say.
  std::string place_of(Address address) const;
  bool may_access_bus(Address place) const;
  // Functions of this name: mangled or as in the source, whole or the part after any `::`.
  std::vector<Address> find(std::string_view name) const;
};

// Throws std::runtime_error that says what is wrong with the file.
Program read_program(const std::filesystem::path& file);

}  // namespace timing
