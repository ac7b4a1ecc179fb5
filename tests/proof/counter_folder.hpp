// SPDX-License-Identifier: Apache-2.0
// A project of one entity, a counter, with its properties and the script that weaves them in.
#pragma once

#include <filesystem>
#include <string>

#include "directories.hpp"
#include "tests/temporary_folder.hpp"

class CounterFolder : public TemporaryFolder {
 public:
  CounterFolder(const std::string& counter, const std::string& properties) {
    write("rtl/counter.vhd", counter);
    write("testbench/proofs/counter.psl", properties);
    const std::filesystem::path script = "tools/hardware/weave_properties.sh";
    std::filesystem::create_directories((path() / script).parent_path());
    std::filesystem::copy(PROJECT_DIRECTORY / script, path() / script);
  }
};

// A bench that a counter from 0 to 5 passes. `connections`: of ports other than clk and count.
inline std::string counter_bench(const std::string& connections = "") {
  return R"(library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity counter_tb is
end entity;

architecture tb of counter_tb is
  signal clk : std_ulogic := '0';
  signal count : unsigned(3 downto 0);
begin
  clk <= not clk after 5 ns;
  uut : entity work.counter port map (clk => clk, )" +
         connections + R"(count => count);
  check : process
  begin
    for clock in 1 to 12 loop
      wait until rising_edge(clk);
      assert count = (clock - 1) mod 6 severity failure;
    end loop;
    std.env.finish;
  end process;
end architecture;
)";
}
