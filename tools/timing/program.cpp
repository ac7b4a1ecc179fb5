// SPDX-License-Identifier: Apache-2.0
// Reading of an image with libelf, and look-ups in it.
#include "tools/timing/program.hpp"

#include <cxxabi.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gelf.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <unordered_map>

#include "tools/timing/lines.hpp"

namespace timing {

namespace {

// All accesses of the bus are its code, and nothing else in the firmware makes a pointer of a
// number: objects lie in memory (tests/repository checks that).
constexpr std::string_view bus_source = "firmware/platform/bus.cpp";

std::string demangled(const char* name) {
  int status = 0;
  char* text = abi::__cxa_demangle(name, nullptr, nullptr, &status);
  std::string result = status == 0 ? text : name;
  std::free(text);
  return result;
}

// Without the arguments: up to the bracket that no template's or other bracket encloses.
std::string without_arguments(std::string name) {
  int depth = 0;
  constexpr char opening = '\x28';  // a bracket alone misleads the check of the format
  constexpr std::string_view nameless = "(anonymous namespace)";
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name.compare(i, nameless.size(), nameless) == 0) {
      i += nameless.size() - 1;
      continue;
    }
    if (name[i] == '<') ++depth;
    if (name[i] == '>') --depth;
    if (name[i] == opening && depth == 0) return name.substr(0, i);
  }
  return name;
}

class Reader {
 public:
  Reader(int descriptor, std::string file) : file_(std::move(file)) {
    elf_version(EV_CURRENT);
    elf_ = elf_begin(descriptor, ELF_C_READ, nullptr);
    GElf_Ehdr header;
    if (elf_ == nullptr || gelf_getehdr(elf_, &header) == nullptr ||
        gelf_getclass(elf_) != ELFCLASS32 || header.e_machine != EM_RISCV) {
      elf_end(elf_);
      throw std::runtime_error(file_ + ": is not a program for 32-bit RISC-V");
    }
  }
  ~Reader() { elf_end(elf_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void read(Program& program) {
    std::size_t names = 0;
    elf_getshdrstrndx(elf_, &names);
    for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf_, section)) != nullptr;) {
      GElf_Shdr header;
      if (gelf_getshdr(section, &header) == nullptr) continue;
      const char* name = elf_strptr(elf_, names, header.sh_name);
      const std::string_view called = name == nullptr ? "" : name;
      if (called == ".text") read_text(section, header, program);
      if (called == ".loop_bounds") read_facts(section, program.markers);
      if (called == ".event_bounds") read_facts(section, program.event_markers);
      if (called == ".task_spans") read_facts(section, program.task_markers);
      if (called == ".call_tables") read_facts(section, program.call_tables);
      if (header.sh_type == SHT_SYMTAB) read_symbols(section, header, program);
    }
    if (program.bytes.empty()) throw std::runtime_error(file_ + ": has no section .text");
    // The linker script says where constants begin.
    const auto end = program.addresses.find("_code_end");
    program.code_end = end != program.addresses.end()
                           ? end->second
                           : program.first + static_cast<Address>(program.bytes.size());
    std::erase_if(program.symbols,
                  [&](const auto& symbol) { return !program.is_code(symbol.first); });
    std::erase_if(program.markers,
                  [&](const LoopMarker& marker) { return !program.is_code(marker.address); });
    std::erase_if(program.event_markers,
                  [&](const EventMarker& marker) { return !program.is_code(marker.address); });
  }

 private:
  static void read_text(Elf_Scn* section, const GElf_Shdr& header, Program& program) {
    const Elf_Data* data = elf_getdata(section, nullptr);
    if (data == nullptr) return;
    const auto* begin = static_cast<const std::uint8_t*>(data->d_buf);
    program.first = static_cast<Address>(header.sh_addr);
    program.bytes.assign(begin, begin + data->d_size);
  }

  template <class Fact>
  static void read_facts(Elf_Scn* section, std::vector<Fact>& facts) {
    const Elf_Data* data = elf_getdata(section, nullptr);
    if (data == nullptr) return;
    for (std::size_t i = 0; i + sizeof(Fact) <= data->d_size; i += sizeof(Fact)) {
      Fact fact;
      std::memcpy(&fact, static_cast<const char*>(data->d_buf) + i, sizeof fact);
      facts.push_back(fact);
    }
  }

  void read_symbols(Elf_Scn* section, const GElf_Shdr& header, Program& program) {
    Elf_Data* data = elf_getdata(section, nullptr);
    if (data == nullptr || header.sh_entsize == 0) return;
    for (std::size_t i = 0; i < header.sh_size / header.sh_entsize; ++i) {
      GElf_Sym symbol;
      if (gelf_getsym(data, static_cast<int>(i), &symbol) == nullptr) continue;
      const char* name = elf_strptr(elf_, header.sh_link, symbol.st_name);
      if (name == nullptr || *name == '\0' || *name == '$' || *name == '.' ||
          symbol.st_shndx == SHN_UNDEF) {
        continue;
      }
      const auto address = static_cast<Address>(symbol.st_value);
      program.addresses[name] = address;
      const auto type = GELF_ST_TYPE(symbol.st_info);
      if (type != STT_FUNC && type != STT_NOTYPE) continue;
      if (symbol.st_shndx == SHN_ABS) continue;
      Symbol& known = program.symbols[address];
      // Of several names that of the function.
      if (!known.name.empty() && type != STT_FUNC) continue;
      known = {.name = without_arguments(demangled(name)),
               .size = static_cast<Address>(symbol.st_size)};
    }
  }

  std::string file_;
  Elf* elf_ = nullptr;
};

}  // namespace

std::uint32_t Program::word_at(Address address) const {
  std::uint32_t word = 0;
  const std::size_t place = address - first;
  if (place < bytes.size()) {
    std::memcpy(&word, &bytes[place], std::min<std::size_t>(4, bytes.size() - place));
  }
  return word;
}

std::optional<std::uint32_t> Program::constant_at(Address address, unsigned size) const {
  const std::size_t place = address - first;
  if (address < first || place + size > bytes.size()) return std::nullopt;
  std::uint32_t value = 0;
  std::memcpy(&value, &bytes[place], size);
  return value;
}

std::string Program::name_of(Address address) const {
  auto after = symbols.upper_bound(address);
  if (after == symbols.begin()) return fmt::format("{:#x}", address);
  return std::prev(after)->second.name;
}

Address Program::function_at(Address address) const {
  const auto after = symbols.upper_bound(address);
  return after == symbols.begin() ? address : std::prev(after)->first;
}

std::string Program::place_of(Address address) const {
  const std::string line = lines ? lines->at(address) : std::string{};
  return line.empty() ? fmt::format("{:#x}", address) : line;
}

bool Program::may_access_bus(Address place) const {
  return !functions_on_bus || functions_on_bus->contains(function_at(place));
}

std::vector<Address> Program::find(std::string_view name) const {
  std::vector<Address> found;
  for (const auto& [address, symbol] : symbols) {
    const std::string_view known = symbol.name;
    const bool is_end = known.size() > name.size() + 2 && known.ends_with(name) &&
                        known.substr(known.size() - name.size() - 2, 2) == "::";
    if (known == name || is_end) found.push_back(address);
  }
  if (const auto mangled = addresses.find(std::string(name));
      found.empty() && mangled != addresses.end() && is_code(mangled->second)) {
    found.push_back(mangled->second);
  }
  return found;
}

Program read_program(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw std::runtime_error(file.string() + ": " + std::strerror(errno));
  Program program;
  program.lines = std::make_shared<const Lines>(descriptor);
  Reader(descriptor, file.string()).read(program);
  std::set<Address> functions;
  for (const Address place : program.lines->places_of(bus_source)) {
    if (program.is_code(place)) functions.insert(program.function_at(place));
  }
  if (!functions.empty()) program.functions_on_bus = std::move(functions);
  return program;
}

}  // namespace timing
