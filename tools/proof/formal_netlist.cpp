// SPDX-License-Identifier: Apache-2.0
// Line by line: GHDL writes assertions, assumptions and free signals always in the same form.
#include "tools/proof/formal_netlist.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

namespace proof {

namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

class Translation {
 public:
  Translation(std::string_view top, const Choice& choice) : top_(top), choice_(choice) {}

  FormalNetlist translate(std::vector<std::string> lines) {
    for (std::size_t number = 0; number < lines.size(); ++number) translate_line(lines, number);
    for (const auto* names : {&choice_.only, &choice_.except}) {
      for (const std::string& property : *names) {
        if (!has(seen_, property)) {
          throw std::runtime_error(fmt::format("{} has no property {}", top_, property));
        }
      }
    }
    result_.verilog = fmt::format("{}\n", fmt::join(lines, "\n"));
    return std::move(result_);
  }

 private:
  static bool has(const std::vector<std::string>& labels, const std::string& property) {
    return std::ranges::any_of(
        labels, [&property](const std::string& label) { return is_property(label, property); });
  }

  void translate_line(std::vector<std::string>& lines, std::size_t number) {
    static const std::regex module_line(R"(^module (\\?[^ (]+).*)");
    static const std::regex wire_line(R"(^  wire (\[[^\]]*\] )?(\w+);$)");
    static const std::regex condition_line(R"(^    if \(!(\w+)\)$)");
    static const std::regex failure_line(R"re(^      \$fatal\(1, "assertion failure (\w+)"\);$)re");
    static const std::regex assume_line(
        R"(^  (\w+): assert (\w+) = '1' severity \w+; --  assume$)");
    static const std::regex free_line(R"(^ *gate_any(const|seq) inst_(\w+) \($)");
    std::string& line = lines[number];
    std::smatch match;
    if (std::regex_match(line, match, module_line)) {
      module_ = match[1];
      wires_.clear();
    } else if (std::regex_match(line, match, wire_line)) {
      wires_[match[2]] = number;
    } else if (std::regex_match(line, match, condition_line)) {
      condition_ = match[1];
    } else if (std::regex_match(line, match, failure_line)) {
      const std::string condition = condition_;
      lines[number - 1].clear();
      line = "    " + assertion(match[1], condition) + ";";
    } else if (std::regex_match(line, match, assume_line)) {
      const std::string label = match[1];
      const std::string condition = match[2];
      if (module_ == top_) {
        result_.assumed.push_back(label);
        line = fmt::format("  always @*\n    {}: assume ({});", label, condition);
      } else {
        line = fmt::format("  always @*\n    {};", assertion(label, condition));
      }
    } else if (std::regex_match(line, match, free_line)) {
      make_free(lines, number, fmt::format("n{}_o", match[2].str()), match[1]);
    } else if (line.find("--  assume") != std::string::npos ||
               line.find("assertion failure") != std::string::npos) {
      throw std::runtime_error("GHDL writes properties in an unknown form: " + line);
    }
  }

  std::string assertion(const std::string& label, const std::string& condition) {
    const auto is_label = [&label](const std::string& property) {
      return is_property(label, property);
    };
    if (std::ranges::any_of(choice_.free,
                            [this](const std::string& entity) {
                              return module_ == entity || module_.starts_with(entity + "_");
                            }) ||
        std::ranges::any_of(choice_.free_copies, [&label](const std::string& copy) {
          return label.find(copy + "_") != std::string::npos;
        })) {
      return "begin end";
    }
    seen_.push_back(label);
    if ((!choice_.only.empty() && std::ranges::none_of(choice_.only, is_label)) ||
        std::ranges::any_of(choice_.except, is_label)) {
      return "begin end";
    }
    result_.asserted.push_back(label);
    return fmt::format("{}: assert ({})", label, condition);
  }

  // The instance has no port: the wire that it should drive becomes a free register.
  void make_free(std::vector<std::string>& lines, std::size_t number, const std::string& wire,
                 const std::string& kind) {
    const auto found = wires_.find(wire);
    if (found == wires_.end() || number + 1 >= lines.size() || lines[number + 1] != ");") {
      throw std::runtime_error("GHDL writes free signals in an unknown form: " + lines[number]);
    }
    std::string& declaration = lines[found->second];
    declaration =
        fmt::format("  (* any{} *) reg{}", kind, declaration.substr(sizeof("  wire") - 1));
    lines[number].clear();
    lines[number + 1].clear();
  }

  const std::string top_;
  const Choice& choice_;
  std::vector<std::string> seen_;
  FormalNetlist result_;
  std::string module_;
  std::string condition_;
  std::map<std::string, std::size_t> wires_;
};

}  // namespace

FormalNetlist make_formal(std::string_view verilog, std::string_view top, const Choice& choice) {
  return Translation(top, choice).translate(lines_of(verilog));
}

bool is_property(std::string_view label, std::string_view property) {
  if (!label.ends_with(property)) return false;
  if (label.size() == property.size()) return true;
  const char before = label[label.size() - property.size() - 1];
  return before == '_' || before == '.';
}

}  // namespace proof
