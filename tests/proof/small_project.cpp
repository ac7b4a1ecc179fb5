// SPDX-License-Identifier: Apache-2.0
// The sources of the small project, and its lists.
#include "tests/proof/small_project.hpp"

#include <stdexcept>

#include "directories.hpp"
#include "tests/proof/counter_folder.hpp"
#include "tools/files/file_text.hpp"

namespace {

const char* const limits = R"(package limits_pkg is
  constant last : natural := 5;
end package;
)";

const char* const counter = R"(library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.limits_pkg.all;

entity counter is
  port (
    clk : in std_ulogic;
    count : out unsigned(3 downto 0) := (others => '0')
  );
end entity;

architecture rtl of counter is
begin

  -- It counts.
  count_on : process
  begin
    wait until rising_edge(clk);
    count <= count + 1;
    if count = last then
      count <= (others => '0');
    end if;
  end process;

end architecture;
)";

const char* const counter_properties = R"(-- What counts.
vunit counter_properties (counter(rtl)) {
  default clock is rising_edge(clk);
  count_stays_below_six : assert always (count < 6);
}
)";

const char* const latch = R"(library ieee;
use ieee.std_logic_1164.all;

entity latch is
  generic (
    sets : natural := 1
  );
  port (
    clk, set : in std_ulogic;
    is_set : out std_ulogic := '0'
  );
end entity;

architecture rtl of latch is
begin

  keep : process
  begin
    wait until rising_edge(clk);
    if set then
      is_set <= '1';
    end if;
  end process;

  -- psl default clock is rising_edge(clk);
  -- psl it_stays_set : assert always
  --   (is_set -> next is_set);

end architecture;
)";

const char* const proofs = R"([[proof]]
name = "counter"
says = "it stays low"
entity = "counter"
by = "induction"
depth = 1
quick = true

[[proof]]
name = "latch"
says = "it stays set"
entity = "latch"
by = "bounded"
depth = 3
generics = {sets = 1}

[[proof]]
name = "counter_stood_in_for"
says = "with another package"
entity = "counter"
by = "bounded"
depth = 3
stand_ins = ["parts/limits_pkg.vhdl"]

[[proof]]
name = "sum"
says = "twice is the sum"
by = "arithmetic"
lemma = "parts/sum.smt2"

[[proof]]
name = "counter_bench"
says = "it counts"
by = "bench"
entity = "counter_tb"
)";

const char* const mutations = R"toml([[mutation]]
name = "counts_too_far"
file = "rtl/counter.vhd"
from = "count = last"
to = "count = last + 1"
proof = "counter"
property = "count_stays_below_six"

[[mutation]]
name = "counts_not_far_enough"
file = "rtl/counter.vhd"
from = "count = last"
to = "count = last - 1"
proof = "counter_bench"

[[mutation]]
name = "forgets"
file = "rtl/latch.vhd"
from = "if set then"
to = "is_set <= set;\n    if set then"
proof = "latch"
property = "it_stays_set"
depth = 4

[[mutation]]
name = "sum_of_three"
file = "testbench/proofs/parts/sum.smt2"
from = "(* 2 x)"
to = "(* 3 x)"
proof = "sum"
)toml";

}  // namespace

SmallProject::SmallProject() {
  write("rtl/limits_pkg.vhd", limits);
  write("rtl/counter.vhd", counter);
  write("rtl/latch.vhd", latch);
  write("testbench/counter_tb.vhd", counter_bench());
  write("testbench/proofs/parts/counter.psl", counter_properties);
  write("testbench/proofs/parts/limits_pkg.vhdl", limits);
  write("testbench/proofs/parts/sum.smt2",
        "(declare-const x Int)\n(assert (not (= (+ x x) (* 2 x))))\n(check-sat)\n");
  write("testbench/proofs/parts/proofs/all.toml", proofs);
  write("testbench/proofs/parts/mutations/all.toml", mutations);
  for (const char* folder : {"proof", "process", "files", "hardware"}) {
    const std::filesystem::path from = std::filesystem::path("tools") / folder;
    std::filesystem::create_directories(path() / from);
    std::filesystem::copy(std::filesystem::path(PROJECT_DIRECTORY) / from, path() / from,
                          std::filesystem::copy_options::recursive);
  }
}

void SmallProject::change(const std::filesystem::path& file, const std::string& from,
                          const std::string& to) const {
  std::string text = files::text_of(path() / file);
  const std::size_t place = text.find(from);
  if (place == std::string::npos || text.find(from, place + 1) != std::string::npos) {
    throw std::runtime_error(file.string() + " does not hold exactly once: " + from);
  }
  write(file, text.replace(place, from.size(), to));
}
