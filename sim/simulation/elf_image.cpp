// SPDX-License-Identifier: Apache-2.0
// Reading of ELF files with libelf.
#include "sim/simulation/elf_image.hpp"

#include <fmt/format.h>
#include <gelf.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "sim/simulation/chip.hpp"

namespace sim {

namespace {

class ElfFile {
 public:
  ElfFile(std::span<const std::uint8_t> contents, const std::string& name)
      : name_(name), contents_(contents.begin(), contents.end()) {
    elf_version(EV_CURRENT);
    elf_ = elf_memory(contents_.data(), contents_.size());
    if (elf_ == nullptr || elf_kind(elf_) != ELF_K_ELF) fail("is not an ELF file");
    if (gelf_getehdr(elf_, &header_) == nullptr || gelf_getclass(elf_) != ELFCLASS32 ||
        header_.e_machine != EM_RISCV) {
      fail("is not a program for 32-bit RISC-V: compile it for -march=rv32imc_zicsr -mabi=ilp32");
    }
    if (header_.e_type != ET_EXEC) fail("is not an executable: link it to fixed addresses");
    if ((header_.e_flags & EF_RISCV_RVE) != 0) {
      fail("is compiled for RV32E with 16 registers: compile it for -mabi=ilp32");
    }
    if ((header_.e_flags & EF_RISCV_FLOAT_ABI) != EF_RISCV_FLOAT_ABI_SOFT) {
      fail(
          "passes floating-point numbers in registers that the chip does not have: compile it for "
          "-march=rv32imc_zicsr -mabi=ilp32");
    }
  }
  ElfFile(const ElfFile&) = delete;
  ElfFile& operator=(const ElfFile&) = delete;
  ~ElfFile() { release(); }

  [[noreturn]] void fail(std::string_view what) {
    release();
    throw std::runtime_error(fmt::format("{}: {}", name_, what));
  }
  Elf* elf() const { return elf_; }
  const GElf_Ehdr& header() const { return header_; }

 private:
  void release() {
    if (elf_ != nullptr) {
      elf_end(elf_);
      elf_ = nullptr;
    }
  }

  std::string name_;
  std::vector<char> contents_;
  Elf* elf_ = nullptr;
  GElf_Ehdr header_{};
};

// A linker without a script puts the file's own header before the first section of the first
// segment, on a page that may lie before the memory. The program does not need it.
std::size_t header_bytes(ElfFile& file, const GElf_Phdr& segment) {
  const GElf_Addr end = segment.p_vaddr + segment.p_memsz;
  GElf_Addr first = end;
  Elf_Scn* section = nullptr;
  while ((section = elf_nextscn(file.elf(), section)) != nullptr) {
    GElf_Shdr header;
    if (gelf_getshdr(section, &header) != nullptr && (header.sh_flags & SHF_ALLOC) != 0 &&
        header.sh_addr >= segment.p_vaddr) {
      first = std::min(first, header.sh_addr);
    }
  }
  return segment.p_offset == 0 && first != end ? first - segment.p_vaddr : 0;
}

constexpr GElf_Xword address_space = GElf_Xword{1} << 32;

// Of all segments, with the zeros that the file leaves out: many times the largest memory of a
// chip. More is a damaged file, and would only fill the memory of this machine.
constexpr GElf_Xword most_loaded_bytes = GElf_Xword{1} << 24;

std::vector<ElfSegment> segments_of(ElfFile& file) {
  std::vector<ElfSegment> segments;
  std::size_t count = 0;
  elf_getphdrnum(file.elf(), &count);
  GElf_Xword loaded_bytes = 0;
  std::size_t file_size = 0;
  const char* content = elf_rawfile(file.elf(), &file_size);
  for (std::size_t i = 0; i < count; ++i) {
    GElf_Phdr header;
    if (gelf_getphdr(file.elf(), static_cast<int>(i), &header) == nullptr) {
      file.fail("has a damaged program header");
    }
    if (header.p_type != PT_LOAD || header.p_memsz == 0) continue;
    if (content == nullptr || header.p_offset + header.p_filesz > file_size ||
        header.p_filesz > header.p_memsz) {
      file.fail("is damaged: a segment lies beyond its end");
    }
    loaded_bytes += header.p_memsz;
    if (loaded_bytes > most_loaded_bytes) {
      file.fail(fmt::format("loads more than {} MiB: it is damaged, or for another machine",
                            most_loaded_bytes >> 20));
    }
    if (header.p_paddr + header.p_memsz > address_space || header.p_vaddr > address_space) {
      file.fail(fmt::format("loads {} bytes at {:#010x}, beyond the end of the address space",
                            header.p_memsz, header.p_paddr));
    }
    const std::size_t skipped = std::min<std::size_t>(header_bytes(file, header), header.p_filesz);
    ElfSegment segment{static_cast<std::uint32_t>(header.p_paddr + skipped),
                       std::vector<std::uint8_t>(header.p_memsz - skipped)};
    std::memcpy(segment.bytes.data(), content + header.p_offset + skipped,
                header.p_filesz - skipped);
    segments.push_back(std::move(segment));
  }
  if (segments.empty()) file.fail("holds nothing to load");
  return segments;
}

void read_symbols(ElfFile& file, Elf_Scn* section, const GElf_Shdr& header, ElfImage& image) {
  Elf_Data* data = elf_getdata(section, nullptr);
  if (data == nullptr || header.sh_entsize == 0) return;
  for (std::size_t i = 0; i < header.sh_size / header.sh_entsize; ++i) {
    GElf_Sym symbol;
    if (gelf_getsym(data, static_cast<int>(i), &symbol) == nullptr) continue;
    const char* name = elf_strptr(file.elf(), header.sh_link, symbol.st_name);
    if (name != nullptr && *name != '\0' && symbol.st_shndx != SHN_UNDEF) {
      image.symbols[name] = static_cast<std::uint32_t>(symbol.st_value);
    }
  }
}

void read_section(ElfFile& file, Elf_Scn* section, ElfImage& image) {
  GElf_Shdr header;
  if (gelf_getshdr(section, &header) == nullptr) return;
  if (header.sh_type == SHT_SYMTAB) read_symbols(file, section, header, image);
  if ((header.sh_flags & SHF_ALLOC) == 0) return;
  std::size_t names = 0;
  elf_getshdrstrndx(file.elf(), &names);
  const char* name = elf_strptr(file.elf(), names, header.sh_name);
  const bool stack = name != nullptr && std::string_view(name).contains("stack");
  const auto size = static_cast<std::uint32_t>(header.sh_size);
  if ((header.sh_flags & SHF_WRITE) == 0) {
    image.sizes.text_bytes += size;
    image.constants.push_back({static_cast<std::uint32_t>(header.sh_addr), size});
  } else if (header.sh_type != SHT_NOBITS) {
    image.sizes.data_bytes += size;
  } else if (!stack) {
    image.sizes.bss_bytes += size;
  }
}

constexpr std::uint32_t memory_start = 0x8000'0000;

// The first address after the chip's memory, the size of which is a multiple of this.
constexpr std::uint32_t memory_unit = 1024;

std::uint64_t memory_end(const Chip& chip) {
  std::uint32_t size = memory_unit;
  try {
    while (size != 0) {
      chip.read_memory(memory_start + size);
      size += memory_unit;
    }
  } catch (const std::out_of_range&) {
  }
  return std::uint64_t{memory_start} + size;
}

// A program that is too large needs another message than one at a wrong address.
void check_place(const ElfSegment& segment, const Chip& chip) {
  const std::uint64_t end = std::uint64_t{segment.address} + segment.bytes.size();
  const std::uint64_t limit = memory_end(chip);
  if (segment.address < memory_start || segment.address >= limit) {
    throw std::runtime_error(
        fmt::format("the program does not fit: it loads {} bytes at {:#010x}, but the chip's "
                    "memory is {:#010x} to {:#010x}: link it there, as with -Ttext={:#010x}",
                    segment.bytes.size(), segment.address, memory_start, limit - 1, memory_start));
  }
  if (end > limit) {
    throw std::runtime_error(fmt::format(
        "the program does not fit: it is too large: it loads {} bytes at {:#010x}, where the "
        "chip's memory has room for {}, to {:#010x}",
        segment.bytes.size(), segment.address, limit - segment.address, limit - 1));
  }
}

}  // namespace

std::optional<std::uint32_t> ElfImage::symbol(const std::string& name) const {
  const auto found = symbols.find(name);
  return found == symbols.end() ? std::nullopt : std::optional(found->second);
}

ElfImage read_elf(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(path.string() + ": is a directory");
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(path.string() + ": " + std::strerror(errno));
  const std::vector<std::uint8_t> contents{std::istreambuf_iterator<char>(stream), {}};
  return parse_elf(contents, path.string());
}

ElfImage parse_elf(std::span<const std::uint8_t> contents, const std::string& name) {
  ElfFile file(contents, name);
  ElfImage image;
  image.entry = static_cast<std::uint32_t>(file.header().e_entry);
  image.segments = segments_of(file);
  Elf_Scn* section = nullptr;
  while ((section = elf_nextscn(file.elf(), section)) != nullptr) {
    read_section(file, section, image);
  }
  return image;
}

void load(const ElfImage& image, Chip& chip) {
  for (const ElfSegment& segment : image.segments) {
    check_place(segment, chip);
    const std::uint64_t end = std::uint64_t{segment.address} + segment.bytes.size();
    // Segments may begin and end within a word.
    for (std::uint64_t word = segment.address & ~3U; word < end; word += 4) {
      std::uint32_t value = chip.read_memory(static_cast<std::uint32_t>(word));
      for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint64_t address = word + i;
        if (address >= segment.address && address < end) {
          value &= ~(0xffU << (8 * i));
          value |= std::uint32_t{segment.bytes[address - segment.address]} << (8 * i);
        }
      }
      chip.write_memory(static_cast<std::uint32_t>(word), value);
    }
  }
}

}  // namespace sim
