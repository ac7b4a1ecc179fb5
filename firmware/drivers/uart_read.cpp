// SPDX-License-Identifier: Apache-2.0
// The loop over the received bytes, apart from the rest because it is compiled for speed.
#include "drivers/uart.hpp"
#include "platform/bus.hpp"
#include "registers/uart_registers.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace drivers {

namespace uart_registers = registers::uart;

template <bool one_line>
[[gnu::always_inline]] inline ReceivedBytes Uart::take(std::span<char> bytes) {
  using Data = uart_registers::Data;
  // In one comparison, since this is done for each byte: it is there, after no gap, and no control
  // character, as the ends of a line are.
  constexpr std::uint32_t least = Data::valid_mask | (one_line ? ' ' : 0);
  constexpr std::uint32_t count = Data::valid_mask + Data::byte_max + 1 - least;
  static_assert(Data::valid_mask == Data::byte_max + 1 && Data::gap_mask > Data::valid_mask);
  char* to = bytes.data();
  char* const end = to + bytes.size();
  bool gap = false;
  if (bytes.empty()) return {};
  std::uint32_t word = platform::bus_read(Data::address);
  if ((word & Data::valid_mask) == 0) return {};
  units::happens<units::Event::read_or_executed>();
  units::LoopBound<uart_registers::receive_depth> reads;
  do {
    reads.next();
    units::happens<units::Event::byte_received>(word);
    const bool is_first = to == bytes.data();
    *to++ = static_cast<char>(word);
    if (word - least >= count) [[unlikely]] {
      gap = (word & Data::gap_mask) != 0;
      if (gap || ends_line(static_cast<unsigned char>(word), is_first)) break;
    }
    if (to == end) break;
    word = platform::bus_read(Data::address);
  } while ((word & Data::valid_mask) != 0);
  const auto taken = static_cast<std::size_t>(to - bytes.data());
  if (one_line) after_second_end_ = static_cast<unsigned char>(to[-1]) == second_end_;
  return {.count = taken, .gap_before_last = gap};
}

bool Uart::ends_line(unsigned char byte, bool is_first) const {
  if (byte == second_end_) return true;
  return byte == first_end_ && !(is_first && after_second_end_);
}

[[gnu::noinline]] ReceivedBytes Uart::read(std::span<char> bytes) { return take<false>(bytes); }

[[gnu::noinline]] ReceivedBytes Uart::read_line(std::span<char> bytes) { return take<true>(bytes); }

}  // namespace drivers
