// SPDX-License-Identifier: Apache-2.0
// The Verilated processor with its memory, clocked by a test.
#include "tests/processor/chip.hpp"

#include <Vprocessor_with_memory.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/processor/chip_memory.hpp"

namespace processor {

std::vector<std::uint8_t> read_image(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

const bool Chip::has_zbb = PROCESSOR_HAS_ZBB;

Chip::Chip(const std::vector<std::uint8_t>& image)
    : context_(std::make_unique<VerilatedContext>()),
      model_(std::make_unique<Vprocessor_with_memory>(context_.get())) {
  model_->eval();  // Initial contents are written over.
  for (std::size_t place = 0; place < memory_size; ++place) {
    write_byte(*model_, place, place < image.size() ? image[place] : std::uint8_t{0});
  }
  model_->reset = 1;
  clock();
  clock();
  model_->reset = 0;
}

Chip::~Chip() { model_->final(); }

void Chip::answer_bus() {
  model_->bus_response_acknowledge = 0;
  model_->bus_response_error = 0;
  model_->bus_response_data = 0;
  if (model_->bus_request_strobe == 0) {
    bus_waited_ = 0;
    return;
  }
  if (bus_waited_++ < bus_wait_) return;
  if (model_->bus_request_write != 0) {
    const bool accepted = device_.write(model_->bus_request_address,
                                        model_->bus_request_select_bytes, model_->bus_request_data);
    (accepted ? model_->bus_response_acknowledge : model_->bus_response_error) = 1;
  } else {
    const auto data = device_.read(model_->bus_request_address & ~3u);
    (data ? model_->bus_response_acknowledge : model_->bus_response_error) = 1;
    model_->bus_response_data = data.value_or(0);
  }
}

std::optional<Retirement> Chip::clock() {
  answer_bus();
  const std::uint32_t requests = device_.interrupts();
  model_->timer_interrupt = requests >> 7 & 1;
  model_->external_interrupt = requests >> 11 & 1;
  model_->interrupts = static_cast<std::uint16_t>(requests >> 16);
  model_->clk = 0;
  model_->eval();
  model_->clk = 1;
  model_->eval();
  ++clocks_;
  if (model_->retirement_valid == 0 && model_->retirement_trap == 0) return std::nullopt;
  return Retirement{.clock = clocks_,
                    .trap = model_->retirement_trap != 0,
                    .interrupt = model_->retirement_interrupt != 0,
                    .address = model_->retirement_address,
                    .instruction = model_->retirement_instruction,
                    .destination = model_->retirement_destination,
                    .value = model_->retirement_destination != 0 ? model_->retirement_value : 0};
}

std::optional<Retirement> Chip::next_retirement(unsigned limit) {
  for (unsigned waited = 0; waited < limit; ++waited) {
    if (auto retirement = clock()) return retirement;
  }
  return std::nullopt;
}

bool Chip::sleeping() const { return model_->sleeping != 0; }

std::uint32_t Chip::word(std::uint32_t address) const {
  std::uint32_t value = 0;
  for (unsigned index = 0; index < 4; ++index) {
    value |= std::uint32_t{read_byte(*model_, address - memory_base + index)} << (8 * index);
  }
  return value;
}

std::vector<std::uint8_t> Chip::memory() const {
  std::vector<std::uint8_t> bytes(memory_size);
  for (std::size_t place = 0; place < memory_size; ++place) {
    bytes[place] = read_byte(*model_, place);
  }
  return bytes;
}

}  // namespace processor
