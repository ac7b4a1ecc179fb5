// SPDX-License-Identifier: Apache-2.0
// Draws the circuits: symbols where the description has them, and wires between their pins.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tools/wiring/outputs.hpp"
#include "tools/wiring/symbols.hpp"

namespace wiring {
namespace {

constexpr double page_width = 100;
constexpr double margin = 2;
constexpr double title_height = 5;

bool is_vertical(const Terminal& terminal) { return terminal.outward.y != 0; }

// A wire leaves a pin in the pin's direction.
std::vector<Place> route(const Terminal& from, const Terminal& to) {
  const Place a = from.at, b = to.at;
  if (a.x == b.x || a.y == b.y) return {a, b};
  if (is_vertical(from) != is_vertical(to)) {
    return {a, is_vertical(from) ? Place{a.x, b.y} : Place{b.x, a.y}, b};
  }
  if (is_vertical(from)) return {a, {a.x, (a.y + b.y) / 2}, {b.x, (a.y + b.y) / 2}, b};
  const bool are_alike = from.outward.x == to.outward.x;
  const double x = !are_alike           ? (a.x + b.x) / 2
                   : from.outward.x > 0 ? std::max(a.x, b.x)
                                        : std::min(a.x, b.x);
  return {a, {x, a.y}, {x, b.y}, b};
}

double distance(const Terminal& one, const Terminal& other) {
  return std::abs(one.at.x - other.at.x) + std::abs(one.at.y - other.at.y);
}

// Each pin to the nearest of those that are connected already.
void draw_net(Drawing& drawing, const std::vector<Terminal>& terminals) {
  std::vector<Terminal> connected{terminals.front()};
  std::vector<Terminal> others(terminals.begin() + 1, terminals.end());
  std::vector<Place> ends;
  while (!others.empty()) {
    std::size_t best = 0, best_end = 0;
    for (std::size_t i = 0; i < others.size(); ++i) {
      for (std::size_t end = 0; end < connected.size(); ++end) {
        if (distance(others[i], connected[end]) < distance(others[best], connected[best_end])) {
          best = i;
          best_end = end;
        }
      }
    }
    drawing.line(route(connected[best_end], others[best]));
    ends.push_back(connected[best_end].at);
    connected.push_back(others[best]);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(best));
    best = 0;
  }
  // Where a third wire meets.
  for (const Terminal& terminal : connected) {
    const auto meets = std::ranges::count_if(
        ends, [&](const Place& end) { return end.x == terminal.at.x && end.y == terminal.at.y; });
    const bool is_first = &terminal == &connected.front();
    if (meets + (is_first ? 0 : 1) > 1) drawing.circle(terminal.at, 0.25, "#222");
  }
}

void draw_supply(Drawing& drawing, const std::string& net, const Terminal& pin) {
  const Place end{pin.at.x + pin.outward.x, pin.at.y + pin.outward.y};
  drawing.line({pin.at, end});
  if (!is_vertical(pin)) {
    const bool is_left = pin.outward.x < 0;
    drawing.text({end.x + (is_left ? -0.3 : 0.3), end.y + 0.35}, net,
                 {.anchor = is_left ? Anchor::end : Anchor::start, .size = 9, .color = "#a00"});
  } else if (net == "GND") {
    for (const auto& [y, half] : {std::pair{0.0, 1.0}, {0.3, 0.6}, {0.6, 0.2}}) {
      drawing.line(
          {{end.x - half, end.y + y * pin.outward.y}, {end.x + half, end.y + y * pin.outward.y}});
    }
  } else {
    drawing.line({{end.x - 0.8, end.y}, {end.x + 0.8, end.y}});
    drawing.text({end.x, end.y + (pin.outward.y < 0 ? -0.4 : 1.1)}, net,
                 {.anchor = Anchor::middle, .size = 9, .color = "#a00"});
  }
}

void draw_port(Drawing& drawing, const Port& port) {
  drawing.polygon({{port.at.x, port.at.y},
                   {port.at.x - 0.5, port.at.y - 0.4},
                   {port.at.x - 0.5, port.at.y + 0.4}},
                  "#06c");
  drawing.text({port.at.x - 0.8, port.at.y + 0.35}, port.net,
               {.anchor = Anchor::end, .size = 9, .color = "#06c"});
}

std::string title_of(const Circuit& circuit) {
  if (circuit.copies.size() == 1) return circuit.title;
  return fmt::format("{}, {} times: {}", circuit.title, circuit.copies.size(),
                     fmt::join(circuit.copies, " "));
}

// "5 A or 15 A", where the copies differ.
std::string value_of(const Description& description, const Circuit& circuit, std::size_t part) {
  std::vector<std::string> values;
  for (const auto& copy : circuit.parts) {
    const Value& value = description.value_of(copy[part]);
    const std::string text = value.number ? shown(*value.number, value.unit) : value.type;
    if (values.empty() || values.back() != text) values.push_back(text);
  }
  return fmt::format("{}", fmt::join(values, " or "));
}

void draw_frame(Drawing& drawing, const Circuit& circuit) {
  drawing.rectangle({0, 0}, {circuit.size.x, circuit.size.y + title_height}, "none", "#bbb");
  drawing.text({1, 1.7}, title_of(circuit), {.size = 13, .is_bold = true});
  if (circuit.copies.size() > 1) {
    drawing.text({1, 3}, "drawn is the first; each other has designators that are 10 higher",
                 {.size = 8, .color = "#666"});
  }
}

void draw_parts(Drawing& drawing, const Description& description, const Circuit& circuit) {
  std::map<std::string, std::vector<Terminal>> nets;
  for (const Port& port : circuit.ports) {
    nets[port.net].push_back({port.at, {1, 0}});
    draw_port(drawing, port);
  }
  const std::vector<Part>& parts = circuit.parts.front();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::vector<Terminal> terminals = terminals_of(description, parts[i]);
    for (std::size_t pin = 0; pin < terminals.size(); ++pin) {
      const std::string& net = parts[i].nets[pin];
      if (is_supply(net)) {
        draw_supply(drawing, net, terminals[pin]);
      } else {
        nets[net].push_back(terminals[pin]);
      }
    }
  }
  for (const auto& [net, terminals] : nets) draw_net(drawing, terminals);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    draw_symbol(drawing, description, parts[i], value_of(description, circuit, i));
  }
}

struct Layout {
  std::vector<Place> origins;
  double height{};
};

// In rows, as words on a line.
Layout layout_of(const Description& description) {
  Layout layout;
  Place next{margin, margin};
  double row_height = 0;
  for (const Circuit& circuit : description.circuits) {
    if (next.x + circuit.size.x + margin > page_width) {
      next = {margin, next.y + row_height + margin};
      row_height = 0;
    }
    layout.origins.push_back(next);
    next.x += circuit.size.x + margin;
    row_height = std::max(row_height, circuit.size.y + title_height);
  }
  layout.height = next.y + row_height + margin;
  return layout;
}

}  // namespace

std::string schematic_picture(const Description& description) {
  const Layout layout = layout_of(description);
  Drawing drawing(page_width, layout.height);
  for (std::size_t i = 0; i < description.circuits.size(); ++i) {
    const Circuit& circuit = description.circuits[i];
    const Place origin = layout.origins[i];
    drawing.begin_group(fmt::format("data-circuit=\"{}\"", circuit.name));
    drawing.move_to(origin);
    draw_frame(drawing, circuit);
    drawing.move_to({origin.x, origin.y + title_height});
    draw_parts(drawing, description, circuit);
    drawing.end_group();
  }
  return drawing.svg("StepFabric interface board: schematic");
}

}  // namespace wiring
