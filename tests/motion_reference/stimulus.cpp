// SPDX-License-Identifier: Apache-2.0
// Stimuli and edges as text.
#include "tests/motion_reference/stimulus.hpp"

#include <iomanip>
#include <istream>
#include <ostream>

namespace motion_reference {
namespace {

constexpr std::uint32_t page_offset_mask = 0xFFFu;

}  // namespace

void save(std::ostream& out, const std::vector<Stimulus>& stimuli) {
  out << std::setfill('0');
  for (const Stimulus& stimulus : stimuli) {
    out << std::dec << stimulus.clock << ' ' << static_cast<int>(stimulus.kind) << ' ' << std::hex
        << std::setw(3) << (stimulus.address & page_offset_mask) << ' ' << std::setw(8)
        << stimulus.value << '\n';
  }
}

std::vector<Stimulus> load_stimuli(std::istream& in, std::uint32_t base) {
  std::vector<Stimulus> stimuli;
  Stimulus stimulus;
  int kind = 0;
  while (in >> std::dec >> stimulus.clock >> kind >> std::hex >> stimulus.address >>
         stimulus.value) {
    stimulus.kind = static_cast<Stimulus::Kind>(kind);
    stimulus.address += base;
    stimuli.push_back(stimulus);
  }
  return stimuli;
}

void save(std::ostream& out, const std::vector<Edge>& edges) {
  for (const Edge& edge : edges) {
    out << std::dec << edge.clock << ' ' << std::hex << std::uppercase << std::setfill('0')
        << std::setw(2) << edge.pins.step << ' ' << std::setw(2) << edge.pins.direction << '\n';
  }
}

}  // namespace motion_reference
