// SPDX-License-Identifier: Apache-2.0
// The options of the job `print`, and what its help says.
#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "tools/command/print_job.hpp"
#include "tools/command/printer_options.hpp"

namespace command {

namespace {

// As many lines as the firmware keeps waiting.
constexpr std::size_t most_window = 8;

std::optional<std::size_t> number_from_1(std::string_view word) {
  std::size_t number = 0;
  const char* end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc() || rest != end || number == 0) return std::nullopt;
  return number;
}

// `all`, how many, or from which to which.
std::string take_replay(const std::string& word, ReplayChoices& choices) {
  choices.asked = true;
  if (word == "all") return {};
  const std::size_t hyphen = word.find('-');
  const auto first = number_from_1(std::string_view(word).substr(0, hyphen));
  if (hyphen == std::string::npos) {
    choices.count = first;
    return first ? "" : "a number from 1, FIRST-LAST, or all";
  }
  const auto last = number_from_1(std::string_view(word).substr(hyphen + 1));
  if (!first || !last || *last < *first) return "FIRST-LAST: two numbers from 1, in this order";
  choices.first = *first;
  choices.last = *last;
  return {};
}

// Its image is linked for more memory than the netlist has.
void check_stepping(const PrintOptions& options) {
  if (options.printer.stepping != "software") return;
  const bool needs_netlist = options.printer.processor == sim::Processor::netlist ||
                             options.printer.every_clock || options.replay.asked ||
                             !options.trace.empty() || !options.board.empty();
  if (!needs_netlist) return;
  throw CLI::ValidationError(
      "--stepping software",
      "has more memory than the chip, which only the model of the processor gives it: omit "
      "--processor netlist, --every-clock, --replay, --trace and --board, or take --stepping "
      "hardware");
}

// The replay compares the processor's model and the leaps of the bare chip with the netlist.
void check_replay(const PrintOptions& options) {
  if (!options.replay.asked) return;
  std::string_view other;
  if (options.printer.every_clock) other = "--every-clock";
  if (options.printer.processor == sim::Processor::netlist) other = "--processor netlist";
  if (!options.board.empty()) other = "--board";
  if (!options.trace.empty()) other = "--trace";
  if (other.empty()) return;
  throw CLI::ValidationError(
      "--replay",
      fmt::format(
          "compares the processor's model and leaps with the netlist, and {0} uses neither: "
          "omit {0} or --replay",
          other));
}

}  // namespace

void add_options(CLI::App& app, PrintOptions& options) {
  CLI::App& job = *app.add_subcommand("print", "Print a G-code file on the simulated printer.");
  job.add_option("file", options.file, "the G-code file")->required()->type_name("FILE.gcode");
  job.add_option("--report", options.report, "folder for report.json and report.html")
      ->type_name("DIR")
      ->capture_default_str();
  job.add_option("--edges", options.edges,
                 "write every rising step edge: cycle,axis,direction,position")
      ->type_name("FILE.csv");
  job.add_option("--trace", options.trace, "write all signals of the chip; slow, and large")
      ->type_name("FILE.fst");
  job.add_option("--board", options.board,
                 "a board's top entity in the place of the bare chip, at 4 MHz; every clock is "
                 "evaluated: slow")
      ->check(CLI::IsMember({"de2_115", "de2_70", "de2_70_reprap_2012", "ulx3s"}))
      ->excludes(job.get_option("--trace"))
      ->type_name("BOARD");
  job.add_option("--stepping", options.printer.stepping,
                 "step generator, or the processor in its timer interrupt, for comparison: with "
                 "more memory than the chip has")
      ->check(CLI::IsMember({"hardware", "software"}))
      ->capture_default_str();
  job.add_option("--until", options.until_seconds, "stop after this many simulated seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  job.add_option("--clock-hz", options.printer.clock_hz, "clock of the chip")
      ->check(CLI::Range(lowest_clock_hz, highest_clock_hz))
      ->capture_default_str();
  job.add_option("--window", options.window,
                 "lines in flight: sent and not yet acknowledged; Printrun and OctoPrint 1, Cura 4")
      ->check(CLI::Range(std::size_t{1}, most_window))
      ->capture_default_str();
  job.add_flag("--no-answer", options.no_answer,
               "end at M0 and M1; by default they are answered at once, as by a user");
  CLI::Option* replay =
      job.add_option(
             "--replay",
             "replay N random intervals of the print, those of a range, or all, on the netlist of "
             "the whole chip: every pin in every clock, and all registers and the memory at their "
             "ends, must be equal; an interval is a million clocks or a little more")
          ->type_name("N|FIRST-LAST|all")
          ->each([&options](const std::string& word) {
            if (const std::string complaint = take_replay(word, options.replay);
                !complaint.empty()) {
              throw CLI::ValidationError("--replay", complaint);
            }
          });
  job.add_option("--replay-seed", options.replay.seed,
                 "seed of that choice; by default a random one, which is printed")
      ->needs(replay);
  job.add_flag("--replay-every-clock", options.replay.every_clock,
               "replay without leaps and rests, as --every-clock does")
      ->needs(replay);
  add_printer_options(job, options.printer);
  job.final_callback([&options] {
    check_stepping(options);
    check_replay(options);
  });
  job.footer(
      R"(The file is sent as by a host program: without comments, with the host's line numbers and
checksums. M110 is not sent; line numbers and valid checksums in the file are removed.

Exit status: 0 good: the whole file (with --until, the part sent by then) was executed to the
exact step. 1 bad: a fault; a line that moves or heats was refused or lost; X, Y, Z or E was not
at its step at the end of a line; the queue ran empty; an illegal pulse or a lost step; a replay
that differs. 2 bad usage, or a file that cannot be printed. 130 interrupted. From its start the
job replaces an earlier report in the folder by one marked as unfinished; bad usage leaves it.
Refused lines that neither move nor heat are warnings.)");
}

}  // namespace command
