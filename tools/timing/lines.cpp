// SPDX-License-Identifier: Apache-2.0
// Look-up of source lines with libdw.
#include "tools/timing/lines.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstddef>

namespace timing {

namespace {

// The compiler writes paths as it got them: from the project's folder on they are the same.
std::string_view within_project(std::string_view path) {
  const auto place = path.rfind("/firmware/");
  return place == std::string_view::npos ? path : path.substr(place + 1);
}

}  // namespace

Lines::Lines(int descriptor)
    : dwarf_(dwarf_begin(descriptor, DWARF_C_READ)), descriptor_(descriptor) {}

Lines::~Lines() {
  if (dwarf_ != nullptr) dwarf_end(dwarf_);
  close(descriptor_);
}

std::string Lines::at(std::uint32_t address) const {
  if (dwarf_ == nullptr) return {};
  Dwarf_Die unit;
  if (dwarf_addrdie(dwarf_, address, &unit) == nullptr) return {};
  Dwarf_Line* line = dwarf_getsrc_die(&unit, address);
  int number = 0;
  if (line == nullptr || dwarf_lineno(line, &number) != 0) return {};
  const char* file = dwarf_linesrc(line, nullptr, nullptr);
  return file == nullptr ? std::string{} : fmt::format("{}:{}", within_project(file), number);
}

std::vector<std::uint32_t> Lines::places_of(std::string_view file) const {
  std::vector<std::uint32_t> places;
  Dwarf_CU* unit = nullptr;
  Dwarf_Die die;
  while (dwarf_ != nullptr &&
         dwarf_get_units(dwarf_, unit, &unit, nullptr, nullptr, &die, nullptr) == 0) {
    Dwarf_Lines* lines = nullptr;
    std::size_t count = 0;
    if (dwarf_getsrclines(&die, &lines, &count) != 0) continue;
    for (std::size_t i = 0; i < count; ++i) {
      Dwarf_Line* line = dwarf_onesrcline(lines, i);
      const char* name = dwarf_linesrc(line, nullptr, nullptr);
      Dwarf_Addr address = 0;
      if (name == nullptr || within_project(name) != file) continue;
      if (dwarf_lineaddr(line, &address) == 0) {
        places.push_back(static_cast<std::uint32_t>(address));
      }
    }
  }
  return places;
}

}  // namespace timing
