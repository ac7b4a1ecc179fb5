// SPDX-License-Identifier: Apache-2.0
// Stepping of other systems: one axis, as they publish it or as measured outside this project
// (software firmwares in simavr, gateware in simulators). Not measured by this benchmark.
#pragma once

#include <array>

namespace benchmarks {

struct PublishedFigure {
  const char* system;
  double clock_mhz;
  double steps_per_second;
  const char* remark;
};

inline constexpr std::array<PublishedFigure, 9> published_figures{{
    {"Java processor in an FPGA (2012)", 60, 500, "published; the origin of this project"},
    {"Marlin 2.0, ATmega, even", 16, 13'950, "measured, one axis"},
    {"Marlin 2.0, ATmega, in bursts", 16, 70'000, "measured; 0.8 ms gaps"},
    {"Teacup, ATmega", 20, 55'200, "measured; beyond it 4 ms stalls"},
    {"Klipper, STM32H723", 520, 7'430'000, "published; a step on both edges"},
    {"LiteX-CNC, FPGA", 50, 790'000, "published"},
    {"conan, FPGA", 48, 5'300'000, "measured"},
    {"hostmot2, FPGA", 50, 8'300'000, "measured; no ramps, no queue"},
    {"TMC4361A, motion chip", 16, 8'000'000, "published; half its clock"},
}};

}  // namespace benchmarks
