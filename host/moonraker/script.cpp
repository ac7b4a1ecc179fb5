// SPDX-License-Identifier: Apache-2.0
// Lines become wishes.
#include "host/moonraker/script.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>

#include "host/moonraker/core.hpp"
#include "host/moonraker/rpc.hpp"

namespace moonraker {

namespace {

using Kind = Step::Kind;
constexpr std::size_t most_lines = 50;  // as many as a feeder keeps

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string_view first_word(std::string_view line) {
  return line.substr(0, line.find_first_of(" \t"));
}

// A letter and a number: nothing else where the word is no G-code.
std::optional<std::pair<char, int>> code_of(std::string_view word) {
  if (word.size() < 2) return std::nullopt;
  int number = 0;
  const auto [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), number);
  const char letter = upper(word.substr(0, 1)).front();
  const bool is_code =
      error == std::errc{} && number >= 0 && (letter == 'G' || letter == 'M' || letter == 'T');
  return is_code ? std::optional(std::pair(letter, number)) : std::nullopt;
}

// NAME=VALUE, with names in upper case.
std::map<std::string, std::string> parameters_of(std::string_view line) {
  std::map<std::string, std::string> found;
  line.remove_prefix(first_word(line).size());
  while (!(line = trimmed(line)).empty()) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) throw Error(400, "a parameter has no value");
    const std::string name = upper(trimmed(line.substr(0, equals)));
    line.remove_prefix(equals + 1);
    std::size_t end = line.find_first_of(" \t");
    if (line.starts_with('"')) {
      line.remove_prefix(1);
      end = line.find('"');
      if (end == std::string_view::npos) throw Error(400, "a quotation mark is open");
    }
    found[name] = line.substr(0, end);
    line.remove_prefix(
        std::min(end == std::string_view::npos ? line.size() : end + 1, line.size()));
  }
  return found;
}

Step sent(std::string line) {
  return {.kind = Kind::wish, .wish = {{"do", "send"}, {"line", std::move(line)}}, .file = {}};
}
Step wish(const char* what) { return {.kind = Kind::wish, .wish = {{"do", what}}, .file = {}}; }

Step heater_step(std::string_view line) {
  auto parameters = parameters_of(line);
  const std::string heater = parameters["HEATER"], target = parameters["TARGET"];
  if (heater != "extruder" && heater != "heater_bed") {
    throw Error(400, "there is no heater '" + heater + "'");
  }
  double value = 0;
  // Without exponents, which are another parameter in G-code.
  const auto [end, error] = std::from_chars(target.data(), target.data() + target.size(), value,
                                            std::chars_format::fixed);
  const bool is_number = error == std::errc{} && end == target.data() + target.size();
  const bool is_good = is_number && value >= 0 && value <= 1000;  // not NaN
  if (!target.empty() && !is_good) {
    throw Error(400, "the temperature '" + target + "' is no number of degrees");
  }
  return sent((heater == "extruder" ? "M104 S" : "M140 S") + (target.empty() ? "0" : target));
}

bool moves(std::pair<char, int> code) {
  return code.first == 'T' || (code.first == 'G' && code.second <= 30);
}
// What the job's next lines mean: G53 to G61, G90 to G92, M82, M83, M200, M206, M428.
bool changes_modes(std::pair<char, int> code) {
  constexpr std::array<int, 5> codes_m{82, 83, 200, 206, 428};
  if (code.first == 'M') return std::ranges::contains(codes_m, code.second);
  return code.first == 'G' &&
         ((code.second >= 53 && code.second <= 61) || (code.second >= 90 && code.second <= 92));
}

void check_code(std::pair<char, int> code, Work work) {
  if (work == Work::none) return;
  if (changes_modes(code) || (moves(code) && work == Work::printing)) {
    throw Error(400, "not while a job is under way: it would change what the job's lines mean");
  }
}

void add_steps(std::string_view line, Work work, std::vector<Step>& steps) {
  const std::string word = upper(first_word(line));
  if (const auto code = code_of(word)) {
    if (*code == std::pair('M', 112)) return steps.push_back(wish("stop"));
    check_code(*code, work);
    return steps.push_back(sent(std::string(line)));
  }
  if (word == "PAUSE") return steps.push_back(wish("pause"));
  if (word == "RESUME") return steps.push_back(wish("resume"));
  if (word == "CANCEL_PRINT") return steps.push_back(wish("cancel"));
  if (word == "BED_CLEAR") {
    return steps.push_back({.kind = Kind::bed_clear, .wish = {}, .file = {}});
  }
  if (word == "FIRMWARE_RESTART" || word == "RESTART") {
    return steps.push_back({.kind = Kind::restart, .wish = {}, .file = {}});
  }
  if (word == "SET_HEATER_TEMPERATURE") return steps.push_back(heater_step(line));
  if (word == "TURN_OFF_HEATERS") {
    steps.push_back(sent("M104 S0"));
    return steps.push_back(sent("M140 S0"));
  }
  if (word == "SDCARD_PRINT_FILE") {
    return steps.push_back(
        {.kind = Kind::print, .wish = {}, .file = parameters_of(line)["FILENAME"]});
  }
  if (word == "SDCARD_RESET_FILE") {
    throw Error(400, "BED_CLEAR confirms that the print has been taken off");
  }
  // Jobs begin in absolute modes; only front ends leave them, between these two.
  if (word == "SAVE_GCODE_STATE" || word == "RESTORE_GCODE_STATE") {
    check_code({'G', 90}, work);
    if (word == "SAVE_GCODE_STATE") return;
    steps.push_back(sent("G90"));
    return steps.push_back(sent("M82"));
  }
  throw Error(400, "Unknown command:\"" + word + "\"");
}

}  // namespace

std::vector<Step> steps_of(std::string_view script, Work work) {
  std::vector<Step> steps;
  while (!script.empty()) {
    const std::size_t end = std::min(script.find('\n'), script.size());
    std::string_view line = script.substr(0, end);
    line = trimmed(line.substr(0, line.find(';')));
    if (!line.empty()) add_steps(line, work, steps);
    if (steps.size() > most_lines) throw Error(400, "a script has at most 50 lines");
    script.remove_prefix(std::min(end + 1, script.size()));
  }
  return steps;
}

void run_script(Core& core, std::string_view script) {
  const PrinterView view = core.view();
  Work work = view.has_active_job() ? Work::printing : Work::none;
  if (view.print_state() == "paused") work = Work::paused;
  for (const Step& step : steps_of(script, work)) {
    switch (step.kind) {
      case Kind::wish:
        core.spooler.ask(core.printer, step.wish);
        break;
      case Kind::bed_clear:
        core.spooler.set_bed_clear(core.printer, true);
        break;
      case Kind::restart:
        core.spooler.restart(core.printer);
        break;
      case Kind::print:
        print_file(core, step.file);
        break;
    }
  }
}

}  // namespace moonraker
