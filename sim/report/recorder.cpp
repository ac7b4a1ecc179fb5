// SPDX-License-Identifier: Apache-2.0
// Connects the parts of the report to the printer and gathers what they found.
#include "sim/report/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/report/firmware_watch.hpp"

namespace report {

namespace {

std::array<std::int64_t, 4> start_positions(const machine::Printer& printer) {
  std::array<std::int64_t, 4> positions{};
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = printer.axis(i).position();
  return positions;
}

// A second extruder begins at 0.
Steps start_of_motors(const machine::Printer& printer) {
  Steps steps{};
  std::ranges::copy(start_positions(printer), steps.begin());
  return steps;
}

std::array<double, 4> resolutions(const machine::Printer& printer) {
  std::array<double, 4> steps_per_mm{};
  for (std::size_t i = 0; i < steps_per_mm.size(); ++i) {
    steps_per_mm[i] = printer.description().axes[i].steps_per_mm;
  }
  return steps_per_mm;
}

ShapingSetting shaping_of(const machine::ShapingDescription& description) {
  ShapingSetting setting{.advance_us = std::llround(description.advance_s * 1e6)};
  for (std::size_t i = 0; i < setting.shapers.size(); ++i) {
    const machine::ShaperDescription& shaper = description.shapers[i];
    setting.shapers[i] = {shaper_named(shaper.type).value_or(ShaperKind::none),
                          std::llround(shaper.frequency_hz * 1e3),
                          std::llround(shaper.damping * 1e4)};
  }
  return setting;
}

MachineFacts facts_of(const machine::Printer& printer) {
  const machine::RetractionDescription& retraction = printer.description().retraction;
  const auto length = [](double millimeters) {
    constexpr double nanometers_per_mm = 1e6;  // the finest of a description
    return Femtometers{std::llround(millimeters * nanometers_per_mm)} * 1'000'000;
  };
  MachineFacts facts{
      {length(retraction.length_mm), length(retraction.lift_mm), length(retraction.extra_mm)},
      {},
      home_of(*printer.description().mechanism)};
  for (std::size_t i = 0; i < facts.travel.size(); ++i) {
    facts.travel[i] = length(printer.description().axes[i].travel_mm.value_or(0));
    facts.steps_per_mm[i] = printer.description().axes[i].steps_per_mm;
  }
  double square = 0;
  for (std::size_t i = 0; i < facts.travel.size(); ++i) {
    square += std::pow(printer.description().axes[i].max_speed_mm_s, 2);
  }
  facts.fastest_mm_s = std::sqrt(square);
  facts.extruder_mm_s = printer.description().axes[3].max_speed_mm_s;
  if (const auto& shaping = printer.description().shaping) facts.shaping = shaping_of(*shaping);
  if (const auto& backlash = printer.description().backlash) {
    PlayFacts& play = facts.play.emplace();
    std::ranges::transform(backlash->lengths_mm, play.lengths.begin(), length);
    play.part = backlash->correction;
  }
  if (const auto& filament = printer.description().filament_change) {
    facts.filament = {length(filament->load_mm), length(filament->unload_mm),
                      length(filament->purge_mm)};
  }
  if (const auto& probe = printer.description().probe) {
    facts.probe = {probe->offset_mm,
                   probe->clearance_mm,
                   {},
                   probe->fade_height_mm,
                   [surface = printer.description().bed_surface](double x, double y) {
                     return surface.height(x, y);
                   }};
    for (std::size_t i = 0; i < facts.probe->lines.size(); ++i) {
      facts.probe->lines[i] = {probe->mesh_from_mm[i], probe->mesh_to_mm[i], probe->mesh_points[i]};
    }
  }
  if (const auto& tool = printer.description().second_tool) {
    ToolFacts& second = facts.second_tool.emplace();
    for (std::size_t i = 0; i < second.offset.size(); ++i) {
      second.offset[i] = length(tool->offset_mm[i]);
    }
    second.swap = length(tool->swap_mm);
    second.resume = length(tool->resume_mm);
    second.prime = length(tool->prime_mm);
    second.lift = length(tool->lift_mm);
  }
  return facts;
}

}  // namespace

Recorder::Recorder(machine::Printer& printer, devices::Host& host, sim::Simulation& simulation,
                   const std::filesystem::path& edges)
    : printer_(printer),
      host_(host),
      simulation_(simulation),
      points_(resolutions(printer), start_of_motors(printer), simulation.rate(), facts_of(printer),
              printer.description().mechanism),
      tool_path_(simulation.rate(), resolutions(printer), start_positions(printer),
                 printer.description().mechanism),
      requested_path_(simulation.rate(), facts_of(printer)),
      axis_courses_(simulation.rate(), resolutions(printer), start_positions(printer)),
      steps_(simulation.rate()),
      chip_record_(simulation.chip(), simulation.rate()),
      hotend_(
          false, simulation.rate(), printer.description().hotend.heater_channel,
          [&printer] { return printer.hotend_c(); }, facts_of(printer)),
      bed_(true, simulation.rate(), printer.description().bed.heater_channel,
           [&printer] { return printer.bed_c(); }),
      messages_(simulation.rate()) {
  printer.add_step_listener(points_);
  printer.add_step_listener(tool_path_);
  printer.add_step_listener(axis_courses_);
  printer.add_step_listener(steps_);
  if (!edges.empty()) {
    edges_ = std::make_unique<EdgeFile>(edges);
    printer.add_step_listener(*edges_);
  }
  const machine::Description& description = printer.description();
  simulation.attach(hotend_, sim::OutputPins::heater_pin(description.hotend.heater_channel),
                    sim::Activity::host_and_report);
  simulation.attach(bed_, sim::OutputPins::heater_pin(description.bed.heater_channel),
                    sim::Activity::host_and_report);
  simulation.attach(chip_record_, {}, sim::Activity::host_and_report);
  host.add_listener(*this);
  if (description.second_tool) {
    const std::size_t channel = description.second_tool->hotend.heater_channel;
    second_hotend_.emplace(
        false, simulation.rate(), channel, [&printer] { return printer.second_hotend_c(); },
        facts_of(printer), 1);
    simulation.attach(*second_hotend_, sim::OutputPins::heater_pin(channel),
                      sim::Activity::host_and_report);
    host.add_listener(*second_hotend_);
  }
  for (devices::HostListener* listener : std::initializer_list<devices::HostListener*>{
           &points_, &refusals_, &requested_path_, &hotend_, &bed_, &messages_}) {
    host.add_listener(*listener);
  }
}

void Recorder::command_acknowledged(sim::Clock, std::size_t, std::string_view command,
                                    bool executed) {
  if (!executed) return;
  const Request request = GcodePath(facts_of(printer_)).read(command);
  if (const Homing* homing = std::get_if<Homing>(&request);
      homing && tool_path_.homed(homing->axes)) {
    requested_path_.begin_here();
  }
}

AxisResult Recorder::axis_result(std::size_t axis) const {
  const devices::PulseCounts& counts = printer_.motor(axis).counts();
  const plants::Axis& plant = printer_.axis(axis);
  return {counts.forward,
          counts.backward,
          plant.position(),
          plant.position_mm(),
          steps_.max_step_rate_hz(axis),
          counts.illegal,
          counts.disabled,
          plant.slipped_steps(),
          printer_.frame_steps(axis),
          0,
          plant.peak_load()};
}

void Recorder::add_findings(Results& results) const {
  PointCheck::Judgement points = points_.judgement();
  results.points_reached = points.reached;
  results.points_missed = points.missed;
  results.findings.missed = std::move(points.list);
  results.findings.missed_by_axis = points.missed_by_axis;
  results.findings.homed_elsewhere = points.homed_elsewhere;
  results.findings.moved_after_end = points.moved_after_end;
  results.findings.lines_apart = points_.lines_apart();
  results.findings.max_height_error_mm = points_.max_height_error_mm();
  for (std::size_t i = 0; i < results.axes.size(); ++i) {
    results.axes[i].unasked_steps = static_cast<std::uint64_t>(points.unasked_steps[i]);
  }
  refusals_.report_to(results.findings);
}

Results Recorder::results(const sim::ElfImage& firmware) const {
  const sim::Chip& chip = simulation_.chip();
  const sim::QueueStatistics queue = chip.queue_statistics();
  const sim::ProcessorStatistics processor = chip.processor_statistics();
  const devices::HostCounts& host = host_.counts();
  Results results;
  results.machine = printer_.description().name;
  results.clock_hz = simulation_.rate().hertz();
  results.cycles = chip.now();
  results.simulated_seconds = simulation_.seconds();
  results.lines_sent = host.lines_sent;
  results.resends = host.resends;
  results.commands_executed = host.commands_executed;
  results.commands_refused = host.commands_refused;
  results.busy_replies = host.busy_replies;
  results.motors = printer_.motors();
  for (std::size_t i = 0; i < results.motors; ++i) results.axes[i] = axis_result(i);
  results.max_deviation_mm = points_.max_deviation_mm();
  results.points_shaped = points_.shaped_points();
  results.max_shaping_mm = points_.max_shaping_mm();
  results.length_mm = points_.length_mm();
  results.max_deviation_steps = points_.max_deviation_steps();
  add_findings(results);
  results.underruns = queue.underruns;
  results.guard_stalls_cycles = queue.guard_stall_clocks;
  results.max_queue_depth = queue.max_depth;
  if (const auto counters = firmware.symbol("software_stepping_counters")) {
    // The words of software_stepping::Counters; the hardware's queue was not used.
    const auto word = [&](std::uint32_t index) { return chip.read_memory(*counters + 4 * index); };
    results.underruns = word(1);
    results.max_queue_depth = word(2);
    results.late_ticks = word(3);
    results.guard_stalls_cycles = word(4);
  }
  results.hotend = hotend_.result();
  results.bed = bed_.result();
  if (second_hotend_) results.second_hotend = second_hotend_->result();
  results.firmware = {firmware.sizes.text_bytes, firmware.sizes.data_bytes,
                      firmware.sizes.bss_bytes, stack_peak_bytes(firmware, chip)};
  const auto cycles = static_cast<double>(chip.now());
  results.processor_busy_percent =
      cycles > 0 ? 100.0 * (1.0 - static_cast<double>(processor.sleeping_clocks) / cycles) : 0.0;
  results.instructions = processor.instructions;
  if (firmware.symbol("statistics")) {
    const FirmwareWatch watch(firmware, chip);
    if (watch.firmware_is_in_memory()) {
      results.longest_pass_clocks = watch.longest_pass_clocks();
      results.tasks = watch.tasks();
    } else {
      results.firmware.stack_peak_bytes = 0;  // of another program nothing is known
    }
  }
  results.serial_bytes_corrupted = printer_.serial_line().bytes_corrupted();
  results.messages = messages_.messages();
  results.messages_dropped = messages_.dropped();
  return results;
}

Courses Recorder::courses() const {
  Courses courses{.path = tool_path_.points(),
                  .asked = requested_path_.lines(),
                  .hotend = hotend_.samples(),
                  .bed = bed_.samples(),
                  .axes = axis_courses_.courses(simulation_.now()),
                  .chip = chip_record_.course(),
                  .intervals = {}};
  std::copy_n(steps_.intervals().begin(), courses.intervals.size(), courses.intervals.begin());
  for (std::size_t i = 0; i < courses.limits.size(); ++i) {
    const machine::AxisDescription& axis = printer_.description().axes[i];
    courses.limits[i] = {axis.steps_per_mm, axis.max_speed_mm_s, axis.max_acceleration_mm_s2,
                         axis.jerk_mm_s};
  }
  return courses;
}

bool Recorder::edges_failed() const { return edges_ && edges_->failed(); }

void Recorder::flush_edges() {
  if (edges_) edges_->flush();
}

void Recorder::close_edges() {
  if (edges_) edges_->close();
}

std::uint32_t stack_peak_bytes(const sim::ElfImage& firmware, const sim::Chip& chip) {
  constexpr std::uint32_t paint = 0xA5A5'A5A5;
  const std::optional<std::uint32_t> bottom = firmware.symbol("_stack_bottom");
  const std::optional<std::uint32_t> top = firmware.symbol("_stack_top");
  if (!bottom || !top) return 0;
  std::uint32_t address = *bottom;
  while (address < *top && chip.read_memory(address) == paint) address += 4;
  return *top - address;
}

}  // namespace report
