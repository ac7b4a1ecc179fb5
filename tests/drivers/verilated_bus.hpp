// SPDX-License-Identifier: Apache-2.0
// Runs firmware drivers, compiled unchanged, against Verilated peripherals: the host's end
// of the bus.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include <verilated.h>

namespace tests {

// The peripheral answered with `error` (or not at all): on the chip this would be a bus error trap.
class BusError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What platform::bus_read and bus_write reach: while it lives, the peripheral at the 4
// KiB page `base`.
class ClockedPeripheral {
 public:
  explicit ClockedPeripheral(std::uint32_t base);
  ClockedPeripheral(const ClockedPeripheral&) = delete;
  ClockedPeripheral& operator=(const ClockedPeripheral&) = delete;
  virtual ~ClockedPeripheral();

  virtual std::uint32_t read(std::uint32_t address) = 0;
  virtual void write(std::uint32_t address, std::uint32_t value) = 0;
};

// A Verilated entity with the ports clk, perhaps bus_clk, reset, request and response:
//   tests::VerilatedPeripheral<Vuart> uart(registers::uart::base);
//   uart->receive_pin = 1;  uart.clock(100);
// Time passes in `clock` and in every access (2 clocks each, as on the chip's bus).
template <class Model>
class VerilatedPeripheral : public ClockedPeripheral {
 public:
  explicit VerilatedPeripheral(std::uint32_t base) : ClockedPeripheral(base) {
    model_->reset = 1;
    clock(2);
    model_->reset = 0;
    now_ = 0;
  }
  ~VerilatedPeripheral() override { model_->final(); }

  // Pins by the names of the entity's ports; an input that is set counts from the next clock on.
  Model* operator->() {
    input_may_have_changed_ = true;
    return model_.get();
  }

  // Clocks since reset.
  std::uint64_t now() const { return now_; }

  // Called after each rising edge, when the outputs are settled: to watch outputs and
  // to drive inputs.
  std::function<void()> after_clock;

  void clock(std::uint64_t count = 1) {
    for (; count > 0; --count) {
      set_clocks(1);
      model_->eval();
      ++now_;
      if (after_clock) after_clock();
      set_clocks(0);
      model_->eval();
    }
  }

  std::uint32_t read(std::uint32_t address) override { return access(address, false, 0); }
  void write(std::uint32_t address, std::uint32_t value) override { access(address, true, value); }

 private:
  // A peripheral has a clock for its registers too; here they always run together. Where it
  // says that it is at rest the edge of its other clock is left out, as the simulation of the
  // whole chip does.
  void set_clocks(unsigned char level) {
    if constexpr (requires { model_->at_rest; }) {
      model_->clk = level != 0 && (!model_->at_rest || input_may_have_changed_);
      if (level != 0) input_may_have_changed_ = false;
    } else {
      model_->clk = level;
    }
    if constexpr (requires { model_->always_clk; }) model_->always_clk = level;
    if constexpr (requires { model_->bus_clk; }) model_->bus_clk = level;
  }

  std::uint32_t access(std::uint32_t address, bool write, std::uint32_t value) {
    constexpr int patience_clocks = 16;
    model_->request_strobe = 1;
    model_->request_write = write;
    model_->request_address = address;
    model_->request_select_bytes = 0xF;
    model_->request_data = value;
    for (int i = 0; i < patience_clocks && !model_->response_acknowledge; ++i) {
      clock();
      if (model_->response_error) break;
    }
    const bool acknowledged = model_->response_acknowledge;
    const std::uint32_t data = model_->response_data;
    model_->request_strobe = 0;
    clock();
    if (!acknowledged) throw BusError((write ? "write to " : "read of ") + std::to_string(address));
    return data;
  }

  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Model> model_ = std::make_unique<Model>(context_.get());
  std::uint64_t now_ = 0;
  bool input_may_have_changed_ = true;
};

}  // namespace tests
