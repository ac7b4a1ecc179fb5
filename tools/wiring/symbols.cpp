// SPDX-License-Identifier: Apache-2.0
// Draws symbols of parts.
#include "tools/wiring/symbols.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace wiring {
namespace {

constexpr double pin_pitch = 3;
constexpr double pin_length = 1;

// A part's own coordinates on the grid.
class Frame {
 public:
  explicit Frame(const Part& part) : part_(part) {}
  Place operator()(double x, double y) const {
    const Place turned = part_.is_turned ? Place{-y, x} : Place{part_.is_mirrored ? -x : x, y};
    return {part_.at.x + turned.x, part_.at.y + turned.y};
  }
  Place direction(double x, double y) const {
    const Place end = (*this)(x, y);
    return {end.x - part_.at.x, end.y - part_.at.y};
  }

 private:
  const Part& part_;
};

// Half the width of a box: that of the driver has names on both sides.
double half_width(const Kind& kind) { return kind.right.size() > 2 ? 5 : 3; }

double row_of(std::size_t index, std::size_t count) {
  return (static_cast<double>(index) - (static_cast<double>(count) - 1) / 2) * pin_pitch;
}

Terminal box_terminal(const Kind& kind, const Frame& frame, const Pin& pin) {
  const double end = half_width(kind) + pin_length;
  for (const auto& [side, pins] : {std::pair{-1.0, &kind.left}, std::pair{1.0, &kind.right}}) {
    const auto found = std::ranges::find(*pins, pin.number);
    if (found == pins->end()) continue;
    const auto index = static_cast<std::size_t>(found - pins->begin());
    return {frame(side * end, row_of(index, pins->size())), frame.direction(side, 0)};
  }
  throw std::runtime_error(fmt::format("{}: no place for pin {}", kind.name, pin.number));
}

void draw_box(Drawing& drawing, const Kind& kind, const Frame& frame, const Part& part) {
  const double half = half_width(kind);
  const double height =
      pin_pitch * static_cast<double>(std::max(kind.left.size(), kind.right.size()));
  drawing.rectangle({part.at.x - half, part.at.y - height / 2}, {2 * half, height}, "#fffbe6");
  for (const Pin& pin : kind.pins) {
    const Terminal terminal = box_terminal(kind, frame, pin);
    const Place edge{terminal.at.x - terminal.outward.x * pin_length, terminal.at.y};
    drawing.line({terminal.at, edge});
    const bool is_left = terminal.outward.x < 0;
    drawing.text(
        {edge.x + (is_left ? 0.4 : -0.4), edge.y + 0.35},
        pin.name == pin.number || kind.name == "relay" ? pin.number : fmt::format("{}", pin.name),
        {.anchor = is_left ? Anchor::start : Anchor::end, .size = 9});
  }
}

void draw_two_pins(Drawing& drawing, const std::string& symbol, const Frame& at) {
  const auto plate = [&](double x) { drawing.line({at(x, -1), at(x, 1)}, "#222", 2); };
  const bool is_capacitor = symbol.ends_with("capacitor");
  const double half = is_capacitor ? 0.3 : symbol == "diode" || symbol == "suppressor" ? 0.7 : 1.2;
  drawing.line({at(-2, 0), at(-half, 0)});
  drawing.line({at(half, 0), at(2, 0)});
  if (is_capacitor) {
    plate(-0.3);
    plate(0.3);
    if (symbol == "electrolytic_capacitor") {
      drawing.line({at(-1.2, -1), at(-0.6, -1)});
      drawing.line({at(-0.9, -1.3), at(-0.9, -0.7)});
    }
  } else if (symbol == "diode" || symbol == "suppressor") {
    // The cathode is the first pin.
    drawing.polygon({at(0.7, -0.8), at(0.7, 0.8), at(-0.7, 0)}, "white");
    drawing.line({at(-0.7, -0.8), at(-0.7, 0.8)}, "#222", 2);
    if (symbol == "suppressor") {
      drawing.line({at(-0.7, -0.8), at(-1.1, -0.8)});
      drawing.line({at(-0.7, 0.8), at(-0.3, 0.8)});
    }
  } else {
    drawing.polygon({at(-1.2, -0.5), at(1.2, -0.5), at(1.2, 0.5), at(-1.2, 0.5)}, "white");
    if (symbol == "fuse") drawing.line({at(-1.2, 0), at(1.2, 0)});
  }
}

void draw_transistor(Drawing& drawing, bool is_mosfet, const Frame& at) {
  drawing.circle(at(0.2, 0), 1.7, "white");
  if (is_mosfet) {
    drawing.line({at(-2, 0), at(-0.8, 0), at(-0.8, -0.8), at(-0.8, 0.8)});
    for (const double y : {-0.9, 0.0, 0.9}) {
      drawing.line({at(-0.3, y - 0.3), at(-0.3, y + 0.3)}, "#222", 2);
    }
    drawing.line({at(-0.3, -0.9), at(1, -0.9), at(1, -2)});
    drawing.line({at(-0.3, 0.9), at(1, 0.9), at(1, 2)});
    drawing.line({at(-0.3, 0), at(1, 0), at(1, 0.9)});
    drawing.polygon({at(-0.2, 0), at(0.4, -0.3), at(0.4, 0.3)}, "#222");
  } else {
    drawing.line({at(-2, 0), at(-0.5, 0)});
    drawing.line({at(-0.5, -0.9), at(-0.5, 0.9)}, "#222", 2);
    drawing.line({at(-0.5, -0.4), at(1, -1.2), at(1, -2)});
    drawing.line({at(-0.5, 0.4), at(1, 1.2), at(1, 2)});
    drawing.polygon({at(0.9, 1.15), at(0.25, 1.1), at(0.5, 0.65)}, "#222");
  }
}

}  // namespace

std::vector<Terminal> terminals_of(const Description& description, const Part& part) {
  const Kind& kind = description.kind_of(part);
  const Frame frame(part);
  std::vector<Terminal> terminals;
  if (kind.symbol == "box") {
    for (const Pin& pin : kind.pins) terminals.push_back(box_terminal(kind, frame, pin));
    return terminals;
  }
  const Terminal left{frame(-2, 0), frame.direction(-1, 0)},
      right{frame(2, 0), frame.direction(1, 0)}, above{frame(1, -2), frame.direction(0, -1)},
      below{frame(1, 2), frame.direction(0, 1)};
  if (kind.symbol == "mosfet") return {left, above, below};
  if (kind.symbol == "transistor") return {above, left, below};
  return {left, right};
}

void draw_symbol(Drawing& drawing, const Description& description, const Part& part,
                 const std::string& value) {
  const Kind& kind = description.kind_of(part);
  const Frame frame(part);
  Place label{part.at.x, part.at.y - 1.9};
  Anchor anchor = Anchor::middle;
  if (kind.symbol == "box") {
    draw_box(drawing, kind, frame, part);
    const auto rows = static_cast<double>(std::max(kind.left.size(), kind.right.size()));
    label.y = part.at.y - rows * pin_pitch / 2 - 1.6;
  } else if (kind.symbol == "mosfet" || kind.symbol == "transistor") {
    draw_transistor(drawing, kind.symbol == "mosfet", frame);
    label = {part.at.x + 2.3, part.at.y};
    anchor = Anchor::start;
  } else {
    draw_two_pins(drawing, kind.symbol, frame);
    if (part.is_turned) {
      label = {part.at.x + 1.5, part.at.y};
      anchor = Anchor::start;
    }
  }
  drawing.text(label, part.designator, {.anchor = anchor, .size = 10, .is_bold = true});
  drawing.text({label.x, label.y + 1.1}, value, {.anchor = anchor, .size = 9, .color = "#06c"});
}

}  // namespace wiring
