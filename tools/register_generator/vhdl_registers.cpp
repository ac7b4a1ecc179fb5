// SPDX-License-Identifier: Apache-2.0
// Writes the VHDL entity of a peripheral's registers: the bus slave that holds them.
#include <algorithm>
#include <bit>
#include <string_view>
#include <utility>
#include <vector>

#include "register_generator/template.hpp"
#include "register_generator/vhdl_names.hpp"
#include "register_generator/vhdl_registers_template.hpp"

namespace register_generator {
namespace {

// One register, or one element of an array of registers.
struct Element {
  const Register& r;
  // Of its word.
  unsigned index;
  // Of its signals.
  std::string name;
  // After a name that is an array where the register is one.
  std::string suffix;

  bool notes_write() const { return r.has_written() && r.stored(); }
  bool has_write_event() const { return r.has_written() && !r.stored(); }
};

std::vector<Element> elements_of(const Peripheral& peripheral) {
  std::vector<Element> found;
  for (const Register& r : peripheral.registers) {
    for (unsigned i = 0; i < r.count; ++i) {
      const unsigned index = r.offset / 4 + i;
      if (r.is_array) {
        found.emplace_back(r, index, fmt::format("{}_{}", r.name, i), fmt::format("({})", i));
      } else {
        found.emplace_back(r, index, r.name, "");
      }
    }
  }
  return found;
}

// True if the address is that of a register for which `kind` holds.
template <class Kind>
std::string any_of(const std::vector<Element>& elements, Kind kind) {
  std::vector<std::pair<unsigned, unsigned>> ranges;
  for (const Element& element : elements) {
    if (!kind(element.r)) continue;
    if (!ranges.empty() && ranges.back().second + 1 == element.index) {
      ranges.back().second = element.index;
    } else {
      ranges.emplace_back(element.index, element.index);
    }
  }
  if (ranges.empty()) return "'0'";
  const std::string address = "request.address(11 downto 2)";
  std::string text;
  for (const auto& [first, last] : ranges) {
    text += text.empty() ? "'1' when " : "\n    or ";
    text += first == last ? fmt::format("{} = {}", address, first)
            : first == 0  ? fmt::format("{} <= {}", address, last)
                          : fmt::format("({0} >= {1} and {0} <= {2})", address, first, last);
  }
  return text + " else '0'";
}

class Writer {
 public:
  Writer(const Peripheral& peripheral, const std::string& source)
      : peripheral_(peripheral), source_(source), elements_(elements_of(peripheral)) {}

  std::string write() const {
    const unsigned last = std::max(1u, elements_.back().index);
    const unsigned index_high = static_cast<unsigned>(std::bit_width(last)) - 1;
    std::string words, reads;
    for (const Element& element : elements_) {
      if (!element.r.readable()) continue;
      words += fmt::format("{}{}_word", words.empty() ? "" : "\n    or ", element.name);
      reads += fill(read_template,
                    {{"name", element.name},
                     {"value", element.r.stored() ? element.name + "_stored"
                                                  : fmt::format("to_software.{}{}", element.r.name,
                                                                element.suffix)},
                     {"index", std::to_string(element.index)}});
    }
    return fill(entity_template,
                {{"unit", peripheral_.name},
                 {"source", source_},
                 {"ports", ports()},
                 {"index_high", std::to_string(index_high)},
                 {"address_high", std::to_string(index_high + 2)},
                 {"signals", signals()},
                 {"readable", any_of(elements_, [](const Register& r) { return r.readable(); })},
                 {"writable", any_of(elements_, [](const Register& r) { return r.writable(); })},
                 {"reads", reads},
                 {"any_word", words.empty() ? "(others => '0')" : words},
                 {"store", store()},
                 {"events", events()},
                 {"connections", connections()}});
  }

 private:
  std::string ports() const {
    std::string text = "response : out bus_response_t := bus_response_idle";
    if (peripheral_.has_from_software()) {
      text += fmt::format(";\nfrom_software : out {}_from_software_t", peripheral_.name);
    }
    if (peripheral_.has_to_software()) {
      text += fmt::format(";\nto_software : in {}_to_software_t", peripheral_.name);
    }
    return text;
  }

  std::string signals() const {
    std::string text;
    for (const Element& element : elements_) {
      if (element.r.readable()) {
        text += fmt::format("signal {}_word : std_ulogic_vector(31 downto 0);\n", element.name);
      }
      if (element.r.stored()) {
        text +=
            fmt::format("signal {}_stored : {} := {}_after_reset;\n", element.name,
                        vhdl_record(peripheral_, element.r), vhdl_register(peripheral_, element.r));
      }
    }
    for (const Element& element : elements_) {
      for (const char* event : events_of(element)) {
        text += fmt::format("signal {}_{} : std_ulogic := '0';\n", element.name, event);
      }
    }
    return text;
  }

  // Writes and reads that the hardware sees in the clock of their acknowledge.
  static std::vector<const char*> events_of(const Element& element) {
    std::vector<const char*> events;
    if (element.has_write_event()) events.push_back("written");
    if (element.r.read_event) events.push_back("read");
    return events;
  }

  std::string store() const {
    std::string stores, resets;
    for (const Element& element : elements_) {
      if (!element.r.stored()) continue;
      const std::string name = vhdl_register(peripheral_, element.r);
      stores += fill(
          one_store_template,
          {{"name", element.name}, {"register", name}, {"index", std::to_string(element.index)}});
      resets += fmt::format("{}_stored <= {}_after_reset;\n", element.name, name);
    }
    return stores.empty() ? "" : fill(store_template, {{"stores", stores}, {"resets", resets}});
  }

  std::string events() const {
    std::string finds, resets;
    for (const Element& element : elements_) {
      for (const std::string event : events_of(element)) {
        const std::string name = element.name + "_" + event;
        finds += fill(one_event_template,
                      {{"event", name},
                       {"direction", event == "written" ? "whole_write" : "not request.write"},
                       {"index", std::to_string(element.index)}});
        resets += name + " <= '0';\n";
      }
    }
    return finds.empty() ? "" : fill(events_template, {{"finds", finds}, {"resets", resets}});
  }

  std::string connections() const {
    std::string notes, text;
    for (const Element& element : elements_) {
      const std::string target = element.r.name + element.suffix;
      for (const std::string event : events_of(element)) {
        text += fmt::format("from_software.{0}_{2}{1} <= {3}_{2};\n", element.r.name,
                            element.suffix, event, element.name);
      }
      if (element.notes_write()) {
        notes += fill(note_template, {{"name", element.name},
                                      {"written", element.r.name + "_written" + element.suffix},
                                      {"index", std::to_string(element.index)}});
      }
      if (element.r.stored()) {
        text += fmt::format("from_software.{} <= {}_stored;\n", target, element.name);
      } else if (element.r.writable()) {
        text += fmt::format("from_software.{} <= to_{}(written_data);\n", target,
                            vhdl_register(peripheral_, element.r));
      }
    }
    return notes + (text.empty() ? "" : "\n" + text);
  }

  const Peripheral& peripheral_;
  const std::string& source_;
  std::vector<Element> elements_;
};

}  // namespace

std::string vhdl_registers(const Peripheral& peripheral, const std::string& source) {
  return Writer(peripheral, source).write();
}

}  // namespace register_generator
