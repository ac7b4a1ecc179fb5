// SPDX-License-Identifier: Apache-2.0
// The tasks of the whole firmware, and the latched halt after a fault.
#include "application/application.hpp"

#include <algorithm>
#include <array>

#include "application/levelling_reports.hpp"
#include "host_link/replies.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace application {

using namespace std::string_view_literals;

namespace {

constexpr units::Milliseconds count_period{100};
constexpr units::Milliseconds cooling_period{1000};
constexpr units::Milliseconds complaint_period{1000};
constexpr units::Hertz fan_frequency{100};
// "Error:Thermal Runaway, system stopped! Heater_ID: 0"
host_link::TextLine text_of(const HeatTask::NamedFault& fault) {
  host_link::TextLine line;
  line.text("Error:").text(thermal::name_of(fault.fault)).text(", system stopped! Heater_ID: ");
  if (units::most_tools > 1 && fault.heater == Heater::hotend_1) {
    line.character('1');
    return line;
  }
  line.text(fault.heater == Heater::bed ? "bed"sv : "0"sv);
  return line;
}

// Empty for M112, which needs no reason.
host_link::TextLine text_of(const Fatal& fatal, const MotionTask& motion) {
  host_link::TextLine line;
  if (fatal.reason == Fatal::Reason::asked_for) return line;
  if (motion.levels() && fatal.reason == Fatal::Reason::probing) {
    return probing_failure(motion.levelling().probing);
  }
  line.text("Error:Homing failed on ");
  line.character(units::axis_letters[units::index_of(fatal.axis)]);
  line.text(": ").text(motion::describe(fatal.fault));
  return line;
}

}  // namespace

Application::Application(const MachineDescription& machine, const ThermalTables& tables,
                         Hardware& hardware, Statistics& counters, const OptionalParts& parts)
    : machine_(machine),
      hardware_(hardware),
      counters_(counters),
      task_watch_(hardware.timer, counters.tasks),
      clock_(hardware.identity.clock),
      motion_(machine, hardware.identity.clock, hardware.step_generator, hardware.end_stops, parts),
      heat_(machine, tables, hardware.identity.clock, hardware.temperature_converter,
            hardware.heater_control),
      executor_(machine, motion_, heat_, hardware.fan, link_, counters, parts.filament) {}

bool Application::start(std::uint32_t baud) {
  if (!hardware_.uart.configure(baud, hardware_.identity.clock)) return false;
  hardware_.uart.set_line_ends(host_link::line_feed, host_link::carriage_return);
  const bool shaped = motion_.start();
  longest_pass_clocks_ = clock_.clocks_in(static_cast<std::uint32_t>(
      std::min(motion_.longest_pass(), motion::Planner::horizon).count()));
  heat_.start();
  hardware_.fan.set_frequency(fan_frequency, hardware_.identity.clock);
  hardware_.fan.set_duty(0);
  // On the chip an address has 32 bits; elsewhere this word is not read.
  counters_.accepted_lines =
      static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(link_.accepted_lines()));
  counters_.version = Statistics::current_version;
  link_.set_advanced_ok(machine_.advanced_ok);
  link_.say(host_link::greeting);
  if (!shaped) link_.say("echo:Input shaping off: its frequency does not fit this clock");
  return true;
}

void Application::act_on_emergencies() {
  using Kind = host_link::EmergencyCommand::Kind;
  // A look takes no more than one line.
  units::LoopBound<1, 1> acted_on;
  while (const auto command = link_.emergency()) {
    acted_on.next();
    switch (command->kind) {
      case Kind::kill: {
        // It has no reason to say.
        units::EventBound<units::Event::character_written, 0> reason;
        units::EventBound<units::Event::byte_queued, host_link::halted.size() + 1> message;
        return halt({});
      }
      case Kind::cancel_wait:
        executor_.cancel_wait();
        break;
      case Kind::quick_stop:
        executor_.quick_stop();
        break;
      case Kind::prompt_response:
        executor_.prompt_answered();
        break;
      case Kind::speed:
        executor_.set_speed_at_once(command->value);
        break;
      case Kind::pause:
      case Kind::resume:
        executor_.hold(command->kind == Kind::pause);
        if (command->kind == Kind::resume) executor_.prompt_answered();
        break;
      case Kind::cancel:
        executor_.cancel_lines();
        break;
    }
  }
}

// What fan and filament take away, which the heaters' model must know: about once a second.
void Application::note_cooling(const Now& now) {
  if (now.milliseconds < next_cooling_) return;
  next_cooling_ = now.milliseconds + cooling_period;
  constexpr std::int32_t most_steps = 2'000'000;  // more is a counter that has jumped
  // No hotend melts more. M92 in mid-move makes more of the same steps than 32 bits would hold.
  constexpr std::int32_t most_melted = 50'000;
  const auto steps =
      static_cast<std::uint32_t>(motion_.steps()[units::index_of(units::Axis::e)].count());
  auto made = static_cast<std::int32_t>(steps - extruder_steps_);
  extruder_steps_ = steps;
  if constexpr (units::most_tools > 1) {
    if (motion_.extruder() != extruder_[0]) {
      made = 0;  // another counter
    }
    extruder_.fill(static_cast<std::uint8_t>(motion_.extruder()));
  }
  const std::int32_t steps_per_mm =
      std::max<std::int32_t>(motion_.limits().of(units::Axis::e).steps_per_meter.count() / 1000, 1);
  heat_.set_cooling(
      {.fan = hardware_.fan.duty(),
       .filament = units::MicrometersPerSecond(std::min<std::int32_t>(
           std::clamp<std::int32_t>(made, 0, most_steps) * 1000 / steps_per_mm, most_melted))});
}

void Application::look_for_faults() {
  if (const auto fault = heat_.fault()) {
    halt(text_of(*fault).view());
  } else if (!heat_.hardware_fault().empty() && !motion_.emergency_input()) {
    halt(heat_.hardware_fault());
  } else if (motion_.emergency_input()) {
    halt("Error:Emergency stop input");
  } else if (motion_.watchdog_stop()) {
    halt("Error:Motion stopped by its watchdog");
  } else if (executor_.fatal()) {
    halt(text_of(*executor_.fatal(), motion_).view());
  }
}

// Says one thing at most; true if it has. Without room a report is left out: the next one is newer.
bool Application::report(const Now& now) {
  const auto due = [now](units::Milliseconds interval, units::Milliseconds& next) {
    if (interval.count() == 0 || now.milliseconds < next) return false;
    next = now.milliseconds + interval;
    return true;
  };
  const ReportCommands& reports = executor_.groups().reports;
  if (!reports.first_temperatures_awaited(now.milliseconds) &&
      due(reports.temperature_interval(), next_report_)) {
    units::happens<units::Event::long_work>();
    say_temperatures();
    return true;
  }
  if (due(reports.position_interval(), next_position_)) {
    units::happens<units::Event::long_work>();
    say_position();
    return true;
  }
  switch_off_idle_motors(now);
  return switch_off_forgotten_heaters(now);
}

void Application::say_temperatures() {
  link_.say(executor_.groups().reports.temperature_line().view());
}

void Application::say_position() { link_.say(executor_.groups().reports.position_line().view()); }

// The heaters must not stay on forever after the host has disconnected.
bool Application::switch_off_forgotten_heaters(const Now& now) {
  if (executor_.activity() == host_link::Activity::processing || !motion_.at_rest()) {
    last_work_ = now.milliseconds;
    link_.work_goes_on();
  }
  const units::Milliseconds quiet = now.milliseconds - std::max(last_work_, link_.last_heard());
  const units::Milliseconds last = executor_.groups().host.inactivity();
  if (last.count() != 0 && quiet >= last) {
    halt("Error:!! KILL caused by too much inactive time");
    return true;
  }
  const units::Milliseconds limit = executor_.groups().host.host_silence();
  if (limit.count() == 0 || quiet < limit || !heat_.wanted()) return false;
  heat_.switch_all_off();
  units::happens<units::Event::long_work>();
  link_.say("echo:No word from the host, heaters off");
  return true;
}

void Application::switch_off_idle_motors(const Now& now) {
  const units::Milliseconds timeout = executor_.groups().motion.motor_timeout();
  if (timeout.count() == 0 || !motion_.at_rest()) {
    at_rest_since_ = now.milliseconds;
    return;
  }
  if (now.milliseconds - at_rest_since_ < timeout) return;
  motion_.enable_motors(units::AxisSet::all(), false);
  at_rest_since_ = now.milliseconds;
}

void Application::count(const Now& now) {
  if (now.milliseconds < next_count_) return;
  next_count_ = now.milliseconds + count_period;
  const auto link = link_.statistics();
  const auto motion = hardware_.step_generator.counters();
  counters_.resends = link.resends;
  counters_.underruns = motion.underruns;
  counters_.guard_stall_clocks = motion.stall_clocks;
  counters_.max_queue_level = motion.max_level;
  counters_.segments = motion.segments;
  counters_.uart_overruns = hardware_.uart.error_counts().overruns;
  counters_.halted = halted_ ? 1 : 0;
}

// Latched until M999 or a reset. `fault` is empty for M112, which needs no reason.
void Application::halt(std::string_view fault) {
  halted_ = true;
  heat_.shut_down();
  units::happens<units::Event::long_work>();
  motion_.shut_down();
  fault_.clear();
  fault_.text(fault);
  counters_.halted = 1;
  if (!fault.empty()) link_.say(fault);
  link_.say(host_link::halted);
}

// Like Marlin after kill() nothing is executed or acknowledged. Unlike Marlin a line that comes is
// answered with the fault again, at most once a second, so that a host that connects now
// learns why. M999 ends it.
void Application::serve_halted(const Now& now) {
  units::EventBound<units::Event::byte_received, units::longest_text> read;
  units::EventBound<units::Event::byte_taken, units::longest_text> taken;
  units::EventBound<units::Event::line_taken, 1> lines;
  units::EventBound<units::Event::byte_queued, host_link::TransmitQueue::capacity> answer;
  std::array<char, units::longest_text> bytes;
  const std::size_t count = hardware_.uart.read_line(bytes).count;
  restart_wanted_ = link_.restart_requested({bytes.data(), count});
  const bool line_ended = units::find({bytes.data(), count}, '\n') != std::string_view::npos;
  if (restart_wanted_ || !line_ended || now.milliseconds < next_complaint_) return;
  next_complaint_ = now.milliseconds + complaint_period;
  if (!fault_.view().empty()) link_.say(fault_.view());
  link_.say(host_link::halted);
}

}  // namespace application
