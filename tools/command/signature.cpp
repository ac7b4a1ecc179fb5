// SPDX-License-Identifier: Apache-2.0
// The signature of a program's run.
#include "tools/command/signature.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "sim/simulation/chip.hpp"
#include "sim/simulation/elf_image.hpp"

namespace command {

namespace {

constexpr std::uint32_t word_bytes = 4;

std::uint32_t address_of(const char* symbol, const sim::ElfImage& image) {
  const auto address = image.symbol(symbol);
  if (!address) {
    throw std::runtime_error(fmt::format(
        "the program has no symbol `{}`, which a signature needs: leave out --signature", symbol));
  }
  return *address;
}

bool holds_words(const Signature& signature, const sim::Chip& chip) {
  if (signature.begin % word_bytes != 0 || signature.end % word_bytes != 0 ||
      signature.begin > signature.end) {
    return false;
  }
  if (signature.begin == signature.end) return true;
  try {
    chip.read_memory(signature.begin);
    chip.read_memory(signature.end - word_bytes);
  } catch (const std::out_of_range&) {
    return false;
  }
  return true;
}

}  // namespace

Signature find_signature(const sim::ElfImage& image, const sim::Chip& chip) {
  const Signature signature{.begin = address_of("begin_signature", image),
                            .end = address_of("end_signature", image)};
  if (!holds_words(signature, chip)) {
    throw std::runtime_error(
        fmt::format("from `begin_signature` at {:#010x} to `end_signature` at {:#010x} there are "
                    "no whole words of the chip's memory",
                    signature.begin, signature.end));
  }
  return signature;
}

void write_signature(const Signature& signature, const sim::Chip& chip,
                     const std::filesystem::path& file) {
  std::ofstream stream(file);
  for (std::uint32_t address = signature.begin; address != signature.end; address += word_bytes) {
    stream << fmt::format("{:08x}\n", chip.read_memory(address));
  }
  if (!stream.flush()) {
    throw std::runtime_error(fmt::format("cannot write the signature to {}", file.string()));
  }
}

}  // namespace command
