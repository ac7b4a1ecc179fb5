// SPDX-License-Identifier: Apache-2.0
// From the Verilog that GHDL writes to the one that Yosys reads for proofs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proof {

struct FormalNetlist {
  std::string verilog;
  std::vector<std::string> asserted;  // labels, once per module
  std::vector<std::string> assumed;
};

// Which assertions of a netlist are to be proved.
struct Choice {
  std::vector<std::string> only = {};  // all where empty
  std::vector<std::string> except = {};
  std::vector<std::string> free = {};  // entities whose own assertions do not count
  std::vector<std::string> free_copies = {};  // copies of a generate statement, likewise
};

// Assertions become `assert`, assumptions of module `top` become `assume`; those of the modules
// within it become `assert` as well: what a part relies on is to be proved of the whole. Signals
// with attribute anyconst or anyseq become free. A property that is chosen or excepted but not
// there is an error (std::runtime_error).
FormalNetlist make_formal(std::string_view verilog, std::string_view top, const Choice& choice);

// Whether a label of the netlist is this property. GHDL puts the names of the process and block
// before it, Yosys those of the instances.
bool is_property(std::string_view label, std::string_view property);

}  // namespace proof
