// SPDX-License-Identifier: Apache-2.0
// Draws what leads from a board's header to the interface board.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "tools/wiring/drawing.hpp"
#include "tools/wiring/outputs.hpp"

namespace wiring {
namespace {

constexpr double row_height = 1.8;
constexpr double page_width = 96;
constexpr double head_height = 7;
constexpr std::array colors{"#1f77b4", "#d62728", "#ff7f0e", "#8c564b",
                            "#2ca02c", "#9467bd", "#e377c2", "#17becf"};

// Where a net of the header goes on the interface board.
struct Destination {
  std::string words;
  std::string color = "#888";
};

Destination destination_of(const Description& description, const std::string& net) {
  if (net.empty()) return {"leave it open", "#fff"};
  if (net == "GND") return {"ground", "#000"};
  if (is_supply(net)) return {"supply of drivers and pull-ups", "#a00"};
  for (std::size_t i = 0; i < description.circuits.size(); ++i) {
    const Circuit& circuit = description.circuits[i];
    for (std::size_t copy = 0; copy < circuit.copies.size(); ++copy) {
      for (const Part& part : circuit.parts[copy]) {
        if (std::ranges::count(part.nets, net) == 0) continue;
        return {fmt::format("{}{}{}, {}", circuit.title, circuit.copies[copy].empty() ? "" : " ",
                            circuit.copies[copy], part.designator),
                colors.at(i % colors.size())};
      }
    }
  }
  return {"", "#fff"};
}

std::string attributes(int position, const std::string& net, const Wire* wire) {
  return fmt::format("data-position=\"{}\" data-net=\"{}\" data-signal=\"{}\" data-pin=\"{}\"",
                     position, net, wire == nullptr ? "" : wire->signal,
                     wire == nullptr ? "" : wire->fpga_pin);
}

const Wire* wire_of(const std::vector<Wire>& wires, const std::string& port) {
  const auto found = std::ranges::find(wires, port, &Wire::port);
  return found == wires.end() ? nullptr : &*found;
}

class Picture {
 public:
  Picture(const Description& description, const Board& board, const std::vector<Wire>& wires,
          const PrinterSignals& printer_signals)
      : description_(description),
        board_(board),
        wires_(wires),
        printer_signals_(printer_signals),
        nets_(nets()),
        drawing_(page_width, height()) {}

  std::string draw() {
    const bool is_header = board_.pattern.empty();
    drawing_.text({2, 2.5}, fmt::format("{}, header {}", board_.title, board_.header),
                  {.size = 14, .is_bold = true});
    drawing_.text({2, 4.2},
                  !board_.printer.empty() ? "To the electronics of the printer, as in 2012."
                  : is_header
                      ? "By ribbon cable to J1 of the interface board, position to position."
                      : "By single wires to J1 of the interface board.",
                  {});
    drawing_.text({2, 5.5}, "Nothing tolerates 5 V. Check supply and ground with a meter first.",
                  {.color = "#a00"});
    is_header ? draw_header() : draw_cable();
    draw_others();
    return drawing_.svg(fmt::format("{}: wiring", board_.title));
  }

 private:
  bool is_elsewhere(const Wire& wire) const { return wire.position == 0 && !wire.is_on_cable; }
  // On the header, but of an adapter.
  bool is_unused(const Wire& wire) const { return std::ranges::count(nets_, wire.port) == 0; }
  // By position: the interface board's, or what the board itself has there.
  std::vector<std::string> nets() const {
    std::vector<std::string> list = description_.header.nets;
    if (board_.printer.empty()) return list;
    for (std::string& net : list) {
      if (!is_supply(net)) net.clear();
    }
    for (const Wire& wire : wires_) {
      if (wire.position != 0) list.at(static_cast<std::size_t>(wire.position) - 1) = wire.port;
    }
    return list;
  }
  Destination destination(const std::string& net, const Wire* wire) const {
    // RESET has the place of ENABLE.
    constexpr std::string_view reset = "motor_reset_n", enable = "motor_enable_n";
    const std::string twin =
        net.starts_with(reset) ? std::string(enable) + net.substr(reset.size()) : net;
    Destination found = destination_of(description_, twin);
    if (board_.printer.empty() || wire == nullptr) return found;
    const auto signal = printer_signals_.find(wire->fpga_pin);
    found.words = signal == printer_signals_.end() ? "not there in 2012" : signal->second;
    return found;
  }
  std::vector<const Wire*> others() const {
    std::vector<const Wire*> list;
    for (const Wire& wire : wires_) {
      if (is_elsewhere(wire) || is_unused(wire)) list.push_back(&wire);
    }
    return list;
  }
  double main_rows() const {
    const auto positions = nets_.size();
    return static_cast<double>(board_.pattern.empty() ? positions / 2 : positions);
  }
  double height() const {
    return head_height +
           row_height * (main_rows() + 4 + static_cast<double>((others().size() + 1) / 2));
  }

  void draw_header() {
    const double middle = page_width / 2;
    drawing_.rectangle({middle - 3, head_height - 1}, {6, row_height * main_rows() + 0.6}, "#eee");
    for (std::size_t i = 0; i < nets_.size(); ++i) {
      const int position = static_cast<int>(i) + 1;
      const bool is_left = position % 2 == 1;
      const double side = is_left ? -1 : 1,
                   y = head_height + row_height * static_cast<double>(i / 2);
      const std::string& net = nets_[i];
      const Wire* wire = wire_of(wires_, net);
      const Destination to = destination(net, wire);
      const bool is_5_volts = std::ranges::count(description_.header.unconnected, position) != 0;
      drawing_.begin_group(attributes(position, net, wire));
      drawing_.circle({middle + side * 1.4, y}, 0.75, to.color);
      drawing_.text(
          {middle + side * 1.4, y + 0.35}, fmt::format("{}", position),
          {.anchor = Anchor::middle, .size = 8, .color = to.color == "#fff" ? "#222" : "white"});
      drawing_.line({{middle + side * 2.2, y}, {middle + side * 4, y}}, to.color, 2);
      const std::string pin =
          wire == nullptr ? "" : fmt::format(" ({} {})", wire->signal, wire->fpga_pin);
      const Anchor anchor = is_left ? Anchor::end : Anchor::start;
      drawing_.text({middle + side * 4.5, y}, (is_5_volts ? "5 V" : net) + pin,
                    {.anchor = anchor, .size = 9, .is_bold = true});
      drawing_.text({middle + side * 4.5, y + 0.85}, to.words,
                    {.anchor = anchor, .size = 8, .color = "#555"});
      drawing_.end_group();
    }
  }

  // In the order of the positions at the interface board.
  void draw_cable() {
    constexpr double left = 18, right = 44;
    for (std::size_t i = 0; i < nets_.size(); ++i) {
      const int position = static_cast<int>(i) + 1;
      const double y = head_height + row_height * static_cast<double>(i);
      const std::string& net = nets_[i];
      const Wire* wire = wire_of(wires_, net);
      const Destination to = destination(net, wire);
      drawing_.begin_group(attributes(position, net, wire));
      const std::string from =
          wire != nullptr ? fmt::format("{} ({})", printed_name(wire->signal), wire->fpga_pin)
          : net == "GND"  ? "GND"
          : net == "+3V3" ? "3.3 V"
                          : "";
      if (!from.empty()) {
        drawing_.text({left, y + 0.35}, from, {.anchor = Anchor::end, .size = 9, .is_bold = true});
        drawing_.line({{left + 0.8, y}, {right - 1.6, y}}, to.color, 2);
      }
      drawing_.circle({right - 0.8, y}, 0.75, to.color);
      drawing_.text(
          {right - 0.8, y + 0.35}, fmt::format("{}", position),
          {.anchor = Anchor::middle, .size = 8, .color = to.color == "#fff" ? "#222" : "white"});
      drawing_.text({right + 1, y + 0.35}, net, {.size = 9, .is_bold = true});
      drawing_.text({right + 16, y + 0.35}, to.words, {.size = 9, .color = "#555"});
      drawing_.end_group();
    }
  }

  void draw_others() {
    const double top = head_height + row_height * (main_rows() + 1.5);
    drawing_.text({2, top - row_height},
                  board_.printer.empty() ? "Not on the interface board:" : "Not on the header:",
                  {.is_bold = true});
    const std::vector<const Wire*> list = others();
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Wire& wire = *list[i];
      const double y = top + row_height * static_cast<double>(i / 2),
                   x = i % 2 == 0 ? 2 : page_width / 2;
      drawing_.begin_group(attributes(0, wire.port, &wire));
      drawing_.text({x, y}, fmt::format("{:<14} {} ({})", wire.port, wire.signal, wire.fpga_pin),
                    {.size = 9});
      drawing_.end_group();
    }
  }

  const Description& description_;
  const Board& board_;
  const std::vector<Wire>& wires_;
  const PrinterSignals& printer_signals_;
  const std::vector<std::string> nets_;
  Drawing drawing_;
};

}  // namespace

std::string wiring_picture(const Description& description, const Board& board,
                           const std::vector<Wire>& wires, const PrinterSignals& printer_signals) {
  return Picture(description, board, wires, printer_signals).draw();
}

std::map<std::filesystem::path, std::string> outputs_of(const std::filesystem::path& project,
                                                        const Description& description) {
  const std::filesystem::path folder = "boards/interface";
  std::map<std::filesystem::path, std::string> outputs{
      {folder / "parts.csv", parts_list(description)},
      {folder / "interface.net", netlist(description)},
      {folder / "schematic.md", schematic_page(description)},
      {folder / "schematic.svg", schematic_picture(description)}};
  for (const Board& board : description.boards) {
    outputs[std::filesystem::path("boards") / board.name / "wiring.svg"] = wiring_picture(
        description, board, wires_of(project, board), printer_signals_of(project, board));
  }
  return outputs;
}

}  // namespace wiring
