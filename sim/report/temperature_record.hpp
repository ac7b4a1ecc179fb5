// SPDX-License-Identifier: Apache-2.0
// Temperatures and the heater's duty over time and how well targets were held, of hotend or bed.
#pragma once

#include <functional>
#include <vector>

#include "sim/devices/host_listener.hpp"
#include "sim/report/gcode_path.hpp"
#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace report {

struct TemperatureSample {
  double seconds{};
  double celsius{};
  double target_c{};
  double duty{};  // part of the time since the sample before in which the heater's gate was open
};

struct TemperatureResult {
  double target_c{};  // the highest that the G-code requested; 0 for none
  double max_c{};
  double seconds_to_target{};  // from the first command to within 1 degree; -1 where never
  double band_c{};  // largest distance from the target while it was held, from M109 or M190 done on
};

class TemperatureRecord : public sim::Device, public devices::HostListener {
 public:
  // `celsius` reads the true temperature of the plant. To be attached to the pin of the heater.
  // Where it is a hotend, it is that of this tool.
  TemperatureRecord(bool bed, sim::ClockRate rate, std::size_t heater_channel,
                    std::function<double()> celsius, const MachineFacts& machine = {},
                    std::size_t tool = 0);

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override;
  void wake(sim::Clock now) override;
  void command_sent(sim::Clock now, std::size_t file_line, std::string_view command) override;
  void command_acknowledged(sim::Clock now, std::size_t file_line, std::string_view command,
                            bool executed) override;

  double celsius() const { return celsius_(); }
  double target_c() const { return target_c_; }
  const std::vector<TemperatureSample>& samples() const { return samples_; }
  TemperatureResult result() const;

 private:
  double take_duty(sim::Clock now);

  bool bed_;
  std::size_t tool_;
  sim::ClockRate rate_;
  std::size_t heater_channel_;
  std::function<double()> celsius_;
  GcodePath gcode_;
  std::vector<TemperatureSample> samples_;
  bool open_ = false;  // the heater's gate
  sim::Clock open_since_ = 0;
  sim::Clock open_clocks_ = 0;  // since the latest sample
  sim::Clock sampled_at_ = 0;
  double target_c_ = 0;
  double first_requested_seconds_ = 0;
  bool held_ = false;
  bool last_is_ours_ = false;  // of the commands that set a target
  TemperatureResult result_{.target_c = 0, .max_c = -300, .seconds_to_target = -1, .band_c = 0};
};

}  // namespace report
