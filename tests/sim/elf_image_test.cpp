// SPDX-License-Identifier: Apache-2.0
// ELF files that no compiler makes, and those that are damaged.
#include "sim/simulation/elf_image.hpp"

#include <elf.h>
#include <gmock/gmock.h>

#include <cstring>
#include <stdexcept>

namespace {

using testing::HasSubstr;

// A program of this many bytes in memory, none of them in the file.
std::vector<std::uint8_t> program_of(std::initializer_list<std::uint32_t> segment_bytes) {
  Elf32_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS32;
  header.e_ident[EI_DATA] = ELFDATA2LSB;
  header.e_ident[EI_VERSION] = EV_CURRENT;
  header.e_version = EV_CURRENT;
  header.e_type = ET_EXEC;
  header.e_machine = EM_RISCV;
  header.e_entry = 0x8000'0000;
  header.e_phoff = header.e_ehsize = sizeof header;
  header.e_phentsize = sizeof(Elf32_Phdr);
  header.e_phnum = static_cast<Elf32_Half>(segment_bytes.size());
  std::vector<std::uint8_t> file(sizeof header);
  std::memcpy(file.data(), &header, sizeof header);
  for (const std::uint32_t bytes : segment_bytes) {
    Elf32_Phdr segment{};
    segment.p_type = PT_LOAD;
    segment.p_vaddr = segment.p_paddr = 0x8000'0000;
    segment.p_memsz = bytes;
    const std::size_t place = file.size();
    file.resize(place + sizeof segment);
    std::memcpy(file.data() + place, &segment, sizeof segment);
  }
  return file;
}

std::string complaint(const std::vector<std::uint8_t>& file) {
  try {
    sim::parse_elf(file, "program.elf");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ElfImage, may_hold_variables_that_the_file_leaves_out) {
  const sim::ElfImage image = sim::parse_elf(program_of({64, 1000}), "program.elf");
  ASSERT_EQ(image.segments.size(), 2U);
  EXPECT_EQ(image.segments[1].bytes, std::vector<std::uint8_t>(1000));
}

// A few bytes must not take this machine's memory.
TEST(ElfImage, of_more_than_any_chip_has_is_refused) {
  EXPECT_THAT(complaint(program_of({0x0fff'ffff})), HasSubstr("loads more than 16 MiB"));
  EXPECT_THAT(complaint(program_of({0x80'0000, 0x80'0000, 1})),
              HasSubstr("loads more than 16 MiB"));
  EXPECT_EQ(complaint(program_of({0x80'0000, 0x80'0000})), "");
}

TEST(ElfImage, that_is_cut_off_is_refused) {
  std::vector<std::uint8_t> file = program_of({64});
  while (!file.empty()) {
    file.pop_back();
    EXPECT_NE(complaint(file), "") << file.size();
  }
}

}  // namespace
