// SPDX-License-Identifier: Apache-2.0
// Where the processor's clocks go, derived from its retired instructions alone.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace benchmarks {

// Besides the one clock that every instruction takes.
enum class Waiting : std::uint8_t {
  late_result,  // of a load, a multiplication or a CSR that the next instruction reads
  branch,  // taken, or mispredicted
  jump,
  division,
  other
};
inline constexpr std::size_t waiting_kinds = 5;
inline constexpr std::array<const char*, waiting_kinds> waiting_names{"late_result", "branch",
                                                                      "jump", "division", "other"};

// How often a situation occurs that a change of the pipeline would make slower or faster.
enum class Event : std::uint8_t {
  load,
  store,
  multiplication,
  division,
  branch_taken_forward,
  branch_taken_backward,
  branch_not_taken,
  jump_direct,
  jump_register,
  late_result_read_next,
  late_result_read_second,  // by the instruction after the next
  result_is_next_address,  // an early result is the base of a load, store or jump after it
  result_is_next_condition,  // or is compared by a branch after it
  compressed
};
inline constexpr std::size_t event_kinds = 14;
inline constexpr std::array<const char*, event_kinds> event_names{"loads",
                                                                  "stores",
                                                                  "multiplications",
                                                                  "divisions",
                                                                  "branches_taken_forward",
                                                                  "branches_taken_backward",
                                                                  "branches_not_taken",
                                                                  "jumps_direct",
                                                                  "jumps_register",
                                                                  "late_results_read_next",
                                                                  "late_results_read_second",
                                                                  "results_as_next_address",
                                                                  "results_as_next_condition",
                                                                  "compressed"};

class ClockUse {
 public:
  // In order: the address of each instruction, its bits, and the clock in which it retires.
  void add(std::uint32_t address, std::uint32_t instruction, std::uint64_t clock);

  std::uint64_t instructions() const { return instructions_; }
  std::uint64_t clocks() const { return clocks_; }
  std::uint64_t waited(Waiting kind) const { return waited_[static_cast<std::size_t>(kind)]; }
  std::uint64_t count(Event kind) const { return counts_[static_cast<std::size_t>(kind)]; }

 private:
  // The properties of an instruction that matter here.
  struct Executed {
    std::uint32_t address{};
    std::uint32_t opcode{};
    std::uint32_t destination{};
    std::uint32_t bytes{};
    std::uint64_t clock{};
    bool late{};
  };

  static bool reads(std::uint32_t word, const std::optional<Executed>& writer);
  void note(Event kind) { ++counts_[static_cast<std::size_t>(kind)]; }
  void note_kind(std::uint32_t word, std::uint32_t bytes);
  void note_branch(const Executed& branch, std::uint32_t next);
  void note_dependence(std::uint32_t word);
  void divide_clocks(std::uint32_t word, std::uint32_t address, std::uint64_t clock);

  std::uint64_t instructions_{};
  std::uint64_t clocks_{};
  std::array<std::uint64_t, waiting_kinds> waited_{};
  std::array<std::uint64_t, event_kinds> counts_{};
  std::optional<Executed> last_, second_last_;
};

}  // namespace benchmarks
