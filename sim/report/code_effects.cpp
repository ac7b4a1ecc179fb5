// SPDX-License-Identifier: Apache-2.0
// The table of codes, from RS-274 and from the firmwares of the field
// (Marlin, RepRapFirmware, Prusa).
#include "sim/report/code_effects.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "sim/report/gcode_words.hpp"

namespace report {

namespace {

struct Range {
  int first{};
  int last{};
};

// All others move (G0-G3 G5 G10 G11 G12 G27-G30 G38 ...) or change where moves go
// (G20 G53-G59 G90-G92).
constexpr std::array harmless_g{
    Range{4, 4},  // dwell
    Range{17, 17},  // the plane of arcs that holds without it
    Range{21, 21},  // millimetres are what holds without it
    Range{40, 40},  // tool radius compensation off
    Range{49, 49},  // tool length offset off
    Range{64, 64},  // path blending
    Range{94, 94},  // feedrate per minute
};

constexpr std::array moving_m{
    Range{6, 6},  // tool change
    Range{23, 24},  // selects and prints a file of the card
    Range{28, 29},  // what is between them is stored, not executed
    Range{32, 32},  // prints a file of the card
    Range{37, 37},  // simulates what is after it (RepRapFirmware)
    Range{44, 46},  // calibration (Prusa)
    Range{48, 48},  // tries the probe
    Range{82, 83},  // meaning of E
    Range{92, 92},  // steps per millimetre
    Range{98, 98},  // macro (RepRapFirmware)
    Range{101, 103},  // extruder on, off (old RepRap)
    Range{104, 104},  // hotend
    Range{109, 109},  // hotend, and waits
    Range{111, 111},  // dry run
    Range{116, 116},  // waits for heat
    Range{125, 125},  // parks the head
    Range{140, 141},  // bed, chamber
    Range{149, 149},  // units of temperatures
    Range{190, 192},   Range{200, 200},  // volumetric extrusion
    Range{163, 166},  // mixing extruder
    Range{206, 206},  // home offset
    Range{218, 218},  // tool offset
    Range{221, 221},  // flow
    Range{290, 290},  // baby steps
    Range{350, 350},  // microsteps
    Range{303, 303},  // heats to find the controller's constants
    Range{306, 306},   Range{360, 364},  // moves of a SCARA
    Range{401, 402},  // probe out, in
    Range{421, 421},  // a point of the bed's mesh
    Range{428, 428},  // home offset
    Range{567, 568},  // mixing, tool temperatures (RepRapFirmware)
    Range{585, 585},  // probes a tool
    Range{600, 606},  // filament change, pause, park, dual carriage
    Range{665, 667},  // geometry of the machine
    Range{669, 669},   Range{701, 704},  // loads, unloads filament
    Range{808, 819},  // repeats, macros
    Range{675, 675},  // finds the middle of a cavity
    Range{851, 852},  // offset of the probe, skew
    Range{915, 918},  // drivers' calibration moves
    Range{951, 951},  // tool parking
    Range{1000, 1000},  // resumes a print
};

template <std::size_t size>
bool within(const std::array<Range, size>& ranges, std::int64_t code) {
  return std::ranges::any_of(
      ranges, [&](const Range& range) { return range.first <= code && code <= range.last; });
}

bool effective(const GcodeWord& word) {
  const std::int64_t code = word.value.value_or(-billionths) / billionths;
  switch (word.letter) {
    case 'G':
      return !within(harmless_g, code);
    case 'M':
      return within(moving_m, code);
    case 'T':
      return true;
    default:
      return false;
  }
}

bool is_macro(std::string_view command) {
  return command.size() > 1 && std::isalpha(static_cast<unsigned char>(command[0])) != 0 &&
         (std::isalpha(static_cast<unsigned char>(command[1])) != 0 || command[1] == '_');
}

}  // namespace

bool moves_or_heats(std::string_view command) {
  const GcodeWords words(command);
  if (words.all().empty()) return false;
  const GcodeWord& first = words.all().front();
  if (is_macro(command)) return true;
  switch (first.letter) {
    case 'G':
    case 'M':
      break;
    case 'T':
      return true;
    case 'F':  // a feedrate alone
    case 'O':  // a program number
    case '%':  // the beginning or end of a program
      return words.all().size() > 1;
    default:
      return true;
  }
  if (effective(first)) return true;
  // Lines follow the mesh from then on; switching that off, or a report, changes nothing that a
  // machine without it could do otherwise.
  if (words.is('M', 420)) return words.has('S') && words.value('S').value_or(billionths) != 0;
  constexpr std::int64_t names_an_object = 486;
  if (first.letter == 'M' && first.value == names_an_object * billionths) return false;
  // A second command in the line, which some firmwares execute and others refuse with the line.
  return std::ranges::any_of(words.all().begin() + 1, words.all().end(), [](const GcodeWord& word) {
    return word.letter == 'G' && effective(word);
  });
}

}  // namespace report
