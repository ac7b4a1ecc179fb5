-- SPDX-License-Identifier: Apache-2.0
-- JTAG debug transport: a test access port (IEEE 1149.1) with the registers dtmcs and dmi.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

use work.debug_pkg.all;
use work.processor_pkg.all;

-- The pins are sampled with the chip's clock, the only one here, so an unplugged debugger leaves nothing
-- undefined. `tck` must be high for at least two clocks and low for five: `tdo` changes with the fourth clock
-- edge after its falling edge, before the rising one. At 50 MHz, 5 MHz are safe.
entity debug_transport is
  generic (
    -- Its lowest bit is 1; bits 11 to 1 are the manufacturer, which is none.
    identity_code : word_t := x"15f01001"
  );
  port (
    clk : in std_ulogic;
    reset : in std_ulogic;
    tck : in std_ulogic;
    tms : in std_ulogic;
    tdi : in std_ulogic;
    tdo : out std_ulogic;
    dmi_request : out dmi_request_t;
    -- Of the request, in the same clock.
    dmi_data : in word_t
  );
end entity;

architecture rtl of debug_transport is

  type state_t is (
    test_logic_reset, run_test_idle,
    select_data, capture_data, shift_data, exit_1_data, pause_data, exit_2_data, update_data,
    select_instruction, capture_instruction, shift_instruction, exit_1_instruction,
    pause_instruction, exit_2_instruction, update_instruction);

  -- Figure 6-1 of the standard: where each state goes with `tms` low and high.
  type destinations_t is array (state_t) of state_t;
  constant with_low : destinations_t := (
    test_logic_reset => run_test_idle, run_test_idle => run_test_idle,
    select_data => capture_data, capture_data => shift_data, shift_data => shift_data,
    exit_1_data => pause_data, pause_data => pause_data, exit_2_data => shift_data,
    update_data => run_test_idle,
    select_instruction => capture_instruction, capture_instruction => shift_instruction,
    shift_instruction => shift_instruction, exit_1_instruction => pause_instruction,
    pause_instruction => pause_instruction, exit_2_instruction => shift_instruction,
    update_instruction => run_test_idle);
  constant with_high : destinations_t := (
    test_logic_reset => test_logic_reset, run_test_idle => select_data,
    select_data => select_instruction, capture_data => exit_1_data, shift_data => exit_1_data,
    exit_1_data => update_data, pause_data => exit_2_data, exit_2_data => update_data,
    update_data => select_data,
    select_instruction => test_logic_reset, capture_instruction => exit_1_instruction,
    shift_instruction => exit_1_instruction, exit_1_instruction => update_instruction,
    pause_instruction => exit_2_instruction, exit_2_instruction => update_instruction,
    update_instruction => select_data);

  subtype instruction_t is std_ulogic_vector(4 downto 0);
  constant select_identity : instruction_t := 5x"01";
  constant select_control : instruction_t := 5x"10";
  constant select_module : instruction_t := 5x"11";

  -- dtmcs: version 0.13, 7-bit addresses. An access is complete long before the next can begin, so there is
  -- never a busy error and no idle clock is needed.
  constant control : word_t := x"00000071";

  signal pins : std_ulogic_vector(2 downto 0);
  signal tck_before, rising, falling : std_ulogic;
  signal state : state_t := test_logic_reset;
  signal instruction, instruction_shift : instruction_t;
  signal data_shift : std_ulogic_vector(40 downto 0);
  signal read_data : word_t;

begin

  synchronize_pins : entity work.synchronizer
    generic map (
      width => 3
    )
    port map (
      clk => clk,
      asynchronous => tck & tms & tdi,
      synchronous => pins,
      settling => open
    );

  rising <= pins(2) and not tck_before;
  falling <= tck_before and not pins(2);

  follow_states : process
  begin
    wait until rising_edge(clk);
    tck_before <= pins(2);
    if rising then
      state <= with_high(state) when pins(1) else with_low(state);
    end if;

    if reset then
      tck_before <= '0';
      state <= test_logic_reset;
    end if;
  end process;

  shift : process
  begin
    wait until rising_edge(clk);
    if rising then
      case state is
        when capture_instruction =>
          instruction_shift <= "00001";
        when shift_instruction =>
          instruction_shift <= pins(0) & instruction_shift(4 downto 1);
        when capture_data =>
          data_shift <= (others => '0');
          if instruction = select_identity then
            data_shift(31 downto 0) <= identity_code;
          elsif instruction = select_control then
            data_shift(31 downto 0) <= control;
          elsif instruction = select_module then
            data_shift <= dmi_request.address & read_data & "00";
          end if;
        when shift_data =>
          data_shift <= '0' & data_shift(40 downto 1);
          if instruction = select_module then
            data_shift(40) <= pins(0);
          elsif instruction = select_identity or instruction = select_control then
            data_shift(31) <= pins(0);
          else
            data_shift(0) <= pins(0);  -- BYPASS
          end if;
        when others => null;
      end case;
    end if;
  end process;

  -- Outputs and instructions change where `tck` falls.
  update : process
  begin
    wait until rising_edge(clk);
    dmi_request.strobe <= '0';
    if falling then
      case state is
        when test_logic_reset =>
          instruction <= select_identity;
        when update_instruction =>
          instruction <= instruction_shift;
        when shift_instruction =>
          tdo <= instruction_shift(0);
        when shift_data =>
          tdo <= data_shift(0);
        when update_data =>
          -- Operation 1 reads, 2 writes; the others do nothing.
          if instruction = select_module and (data_shift(0) xor data_shift(1)) = '1' then
            dmi_request.strobe <= '1';
            dmi_request.write <= data_shift(1);
            dmi_request.address <= data_shift(40 downto 34);
            dmi_request.data <= data_shift(33 downto 2);
          end if;
        when others => null;
      end case;
    end if;
    if dmi_request.strobe then
      read_data <= dmi_data;
    end if;

    if reset then
      instruction <= select_identity;
      dmi_request.strobe <= '0';
      tdo <= '0';
    end if;
  end process;

end architecture;
