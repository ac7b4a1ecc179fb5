// SPDX-License-Identifier: Apache-2.0
// The table of commands: what the firmware executes, in order of letter and code. The page
// gcodes.md (target generate) and M115's capabilities are made from it.
#pragma once

#include <array>

#include "application/gcode_arguments.hpp"

namespace application {

inline constexpr auto gcode_table = [] {
  using namespace gcode_arguments;
  return std::to_array<GcodeRow>({
      g(0, handler<&MotionCommands::move>, "straight move, as G1", move,
        {.start = Start::with_room, .refuses_others = true}),
      g(1, handler<&MotionCommands::move>, "straight move", move,
        {.start = Start::with_room, .refuses_others = true}),
      g(2, handler<&MotionCommands::arc, true>,
        "clockwise arc about the centre I J K from its start, or of radius R; also a helix; a full "
        "circle where it ends at its start",
        arc, {.start = Start::with_room, .refuses_others = true}),
      g(3, handler<&MotionCommands::arc, false>, "the same counter-clockwise", arc,
        {.start = Start::with_room, .refuses_others = true}),
      g(4, handler<&MotionCommands::dwell>, "waits for this time", time, {.start = Start::at_rest}),
      g(17, handler<&CoordinateCommands::set_plane, motion::Plane::xy>, "arcs lie in XY (I J)"),
      g(18, handler<&CoordinateCommands::set_plane, motion::Plane::zx>, "arcs lie in ZX (K I)"),
      g(19, handler<&CoordinateCommands::set_plane, motion::Plane::yz>, "arcs lie in YZ (J K)"),
      g(20, handler<&CoordinateCommands::set_inches, true>, "lengths are inches"),
      g(21, handler<&CoordinateCommands::set_inches, false>, "lengths are millimetres"),
      g(28, handler<&MotionCommands::home>,
        "homes the named axes, or all; goes a back-off beyond where the end stop is or can be at "
        "most, then halts until reset",
        homing, {.start = Start::at_rest, .refuses_others = true}),
      g(90, handler<&CoordinateCommands::set_relative, false>, "positions are absolute"),
      g(91, handler<&CoordinateCommands::set_relative, true>, "positions are relative"),
      g(92, handler<&CoordinateCommands::set_position>, "the present place has these coordinates",
        position, {.refuses_others = true}),
      m(0, handler<&HostCommands::ask_user, Question::go_on>,
        "asks the user and waits for M108, M876 or this time", question, {.start = Start::at_rest}),
      m(1, handler<&HostCommands::ask_user, Question::go_on>, "as M0", question,
        {.start = Start::at_rest}),
      m(17, handler<&MotionCommands::switch_on>, "motors on", axes),
      m(18, handler<&MotionCommands::switch_off>, "as M84", motors_off,
        {.start = Start::at_rest_but_with_s}),
      m(23, handler<&FileCommands::select>, "refused, there is no card", name,
        {.while_dry_run = true}),
      m(24, handler<&FileCommands::resume>,
        "asks the host to resume; refused after a refused M23 or M32"),
      m(25, handler<&HostCommands::request_pause>, "asks the host to pause"),
      m(28, handler<&FileCommands::begin_storing>,
        "refused, there is no card; what comes until M29 is not executed", name,
        {.while_dry_run = true}),
      m(29, handler<&FileCommands::end_storing>, "refused, there is no card", name,
        {.while_storing = true}),
      m(32, handler<&FileCommands::select>, "refused, there is no card", name,
        {.while_dry_run = true}),
      m(37, handler<&DryRunCommands::simulate>,
        "refused, there is no simulation; what comes after an S other than 0 is not executed "
        "until S0",
        simulation, {.while_dry_run = true}),
      m(73, handler<&HostCommands::accept>, "accepted; there is no display"),
      m(82, handler<&CoordinateCommands::set_extruder_relative, false>, "E is absolute"),
      m(83, handler<&CoordinateCommands::set_extruder_relative, true>, "E is relative"),
      m(84, handler<&MotionCommands::switch_off>,
        "motors off; with S only: off after this time at rest", motors_off,
        {.start = Start::at_rest_but_with_s}),
      m(86, handler<&HostCommands::set_host_silence>,
        "heaters off after this time without the host, 0 never", silence,
        {.report = handler<&HostCommands::report_host_silence>}),
      m(92, handler<&SettingCommands::set_steps_per_millimeter>, "steps per millimetre", steps,
        {.start = Start::at_rest, .report = handler<&SettingCommands::report>}),
      m(104, handler<&HeatCommands::set_temperature, Heater::hotend>, "target of the hotend",
        hotend),
      m(105, handler<&ReportCommands::report_temperature>, "temperatures", {},
        {.answered_ahead = true, .while_storing = true}),
      m(106, handler<&HeatCommands::set_fan>, "fan on", fan),
      m(107, handler<&HeatCommands::stop_fan>, "fan off", other_fan),
      m(108, handler<&HostCommands::accept>, "ends a wait for heat or for the user", {},
        {.on_reception = true}),
      m(109, handler<&HeatCommands::set_and_wait, Heater::hotend>,
        "as M104 and waits; S: until hot, R: until there", hotend_wait),
      m(110, handler<&HostCommands::accept>, "the number of the last line", line_number,
        {.while_storing = true}),
      m(111, handler<&DryRunCommands::set_debug_bits>,
        "refused with bit 8, there is no dry run, and what comes until an S without that bit is "
        "not executed; the other bits have no effect",
        debug_bits, {.report = handler<&DryRunCommands::report_debug_bits>, .while_dry_run = true}),
      m(112, handler<&HostCommands::stop_everything>, "emergency stop: everything ends until reset",
        {}, {.on_reception = true}),
      m(113, handler<&HostCommands::set_busy_interval>, "interval of `busy` messages, 0 never",
        interval, {.report = handler<&HostCommands::report_busy_interval>}),
      m(114, handler<&ReportCommands::report_position>, "position and step counters", {},
        {.answered_ahead = true, .while_storing = true}),
      m(115, handler<&ReportCommands::report_firmware>, "firmware and capabilities", {},
        {.answered_ahead = true, .while_storing = true}),
      m(117, handler<&HostCommands::accept>, "accepted; there is no display", message),
      m(118, handler<&HostCommands::say_text>,
        "says the text; A1 as an action (`//`), E1 as an echo, and so a text that begins as an "
        "answer does (`ok`, `Resend`)",
        marked_message),
      m(119, handler<&ReportCommands::report_end_stops>, "end stops", {}, {.while_storing = true}),
      m(140, handler<&HeatCommands::set_temperature, Heater::bed>, "target of the bed", bed),
      m(149, handler<&HeatCommands::set_units>,
        "C: temperatures are in °C; F and K are refused, and temperatures until C or reset, but "
        "not S0, which is off in each unit",
        temperature_units, {.report = handler<&HeatCommands::report_units>, .while_dry_run = true}),
      m(154, handler<&ReportCommands::set_position_interval>, "position every S seconds, 0 never",
        interval),
      m(155, handler<&ReportCommands::set_temperature_interval>,
        "temperatures every S seconds, 0 never", interval),
      m(190, handler<&HeatCommands::set_and_wait, Heater::bed>,
        "as M140 and waits; S: until hot, R: until there", bed_wait),
      m(201, handler<&SettingCommands::set_max_accelerations>, "highest accelerations",
        axis_accelerations, {.report = handler<&SettingCommands::report>}),
      m(203, handler<&SettingCommands::set_max_speeds>, "highest speeds", axis_speeds,
        {.report = handler<&SettingCommands::report>}),
      m(204, handler<&SettingCommands::set_accelerations>,
        "acceleration of print, travel, retraction moves; S: print and travel", accelerations,
        {.report = handler<&SettingCommands::report>}),
      m(205, handler<&SettingCommands::set_advanced>, "jerk; slowest print and travel move",
        advanced, {.report = handler<&SettingCommands::report>}),
      m(220, handler<&FactorCommands::set_speed>,
        "speed of the lines after it, or at once if a person sends it; B keeps the factor, R "
        "restores it",
        speed_factor, {.report = handler<&FactorCommands::report_speed>}),
      m(221, handler<&FactorCommands::set_flow>, "flow", flow_factor,
        {.report = handler<&FactorCommands::report_flow>}),
      m(400, handler<&HostCommands::accept>, "waits until all moves are made", {},
        {.start = Start::at_rest}),
      m(410, handler<&MotionCommands::quick_stop>, "stops all motion and forgets what was planned",
        {}, {.on_reception = true}),
      m(503, handler<&SettingCommands::list>, "M92 and M201 to M205 as they hold, in mm"),
      m(524, handler<&HostCommands::request_cancel>, "asks the host to cancel"),
      m(600, handler<&HostCommands::ask_user, Question::change_filament>,
        "filament change: asks the user and waits for M602, M108, M876", {},
        {.start = Start::at_rest}),
      m(601, handler<&HostCommands::ask_user, Question::end_pause>,
        "pause: asks the user and waits for M602, M108, M876", {}, {.start = Start::at_rest}),
      m(602, handler<&HostCommands::accept>, "ends the wait of M0, M600 or M601", {},
        {.on_reception = true}),
      m(808, handler<&HostCommands::refuse_repeats>,
        "refused: no repeats, the lines after it are executed once", repeats),
      m(876, nullptr, "the user's answer to M0, M600 and M601", answer, {.on_reception = true}),
      m(997, handler<&HostCommands::update_firmware>,
        "into the boot loader ([`../boot_loader`](../boot_loader)), for a new program", {},
        {.start = Start::at_rest}),
      t(0, handler<&HeatCommands::select_tool>,
        "the only tool; another is refused (`echo:T1 Invalid extruder`)"),
  });
}();

// For the search, and one row for each.
constexpr bool comes_before(const GcodeRow& first, const GcodeRow& second) {
  return first.letter < second.letter ||
         (first.letter == second.letter && first.code < second.code);
}
static_assert(std::ranges::adjacent_find(gcode_table,
                                         [](const auto& first, const auto& second) {
                                           return !comes_before(first, second);
                                         }) == gcode_table.end(),
              "the rows of the table of commands are in order of letter and code");

}  // namespace application
