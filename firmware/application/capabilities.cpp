// SPDX-License-Identifier: Apache-2.0
// Capabilities follow from the table of commands.
#include "application/capabilities.hpp"

#include "application/gcode_table.hpp"

namespace application {
namespace {

consteval const GcodeRow* row_of(char letter, std::uint16_t code) {
  const auto row = std::ranges::find_if(gcode_table, [letter, code](const GcodeRow& candidate) {
    return candidate.letter == letter && candidate.code == code;
  });
  return row == gcode_table.end() ? nullptr : &*row;
}

// "Cap:NAME:1" where the table has the command that it stands for.
consteval host_link::Capability if_executed(std::string_view name, char letter,
                                            std::uint16_t code) {
  return {name, row_of(letter, code) != nullptr};
}

consteval host_link::Capability if_on_reception(std::string_view name, char letter,
                                                std::uint16_t code) {
  const GcodeRow* row = row_of(letter, code);
  return {name, row != nullptr && row->conduct.on_reception};
}

constexpr std::array<host_link::Capability, capability_count> list{
    host_link::Capability{"EEPROM", false},
    if_executed("AUTOREPORT_TEMP", 'M', 155),
    if_executed("AUTOREPORT_POS", 'M', 154),
    if_executed("PROGRESS", 'M', 530),
    if_on_reception("EMERGENCY_PARSER", 'M', 112),
    if_executed("SDCARD", 'M', 20),
    if_executed("ARCS", 'G', 2),
    if_executed("HOST_ACTION_COMMANDS", 'M', 25),
    if_on_reception("PROMPT_SUPPORT", 'M', 876),
    {"ADVANCED_OK", false}};

}  // namespace

const std::array<host_link::Capability, capability_count>& capabilities() { return list; }

}  // namespace application
