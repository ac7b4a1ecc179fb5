// SPDX-License-Identifier: Apache-2.0
// A JTAG adapter on the chip's debug port, moved by OpenOCD over TCP (its driver remote_bitbang).
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sim/simulation/device.hpp"

namespace devices {

// One debugger at a time; a second one waits until the first has left. Only programs of
// this machine can connect. Reset lines are not connected: OpenOCD resets the chip through
// its debug module.
class DebugAdapter : public sim::Device {
 public:
  // Port 0 takes any that is free. Throws std::system_error where the port cannot be had.
  DebugAdapter(std::uint16_t port, sim::InputPins& inputs);
  ~DebugAdapter() override;

  std::function<void(sim::Clock now)> on_connect;
  std::function<void(sim::Clock now)> on_disconnect;

  std::uint16_t port() const { return port_; }

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override;
  void wake(sim::Clock now) override;

 private:
  void listen_on(std::uint16_t port);
  void look_for_debugger(sim::Clock now);
  void disconnect(sim::Clock now);
  // False where nothing has come.
  bool receive(sim::Clock now);
  // Executes requests up to the next change of a pin. False if nothing is left to do.
  bool move_pins();
  bool obey(char request);
  void send_replies();

  sim::JtagPins& pins_;
  bool output_ = false;
  std::uint16_t port_ = 0;
  int listener_ = -1;
  int debugger_ = -1;
  bool leaving_ = false;
  std::string requests_;
  std::size_t next_request_ = 0;
  std::string replies_;
};

}  // namespace devices
