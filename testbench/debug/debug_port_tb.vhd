-- SPDX-License-Identifier: Apache-2.0
-- A debugger on the JTAG pins halts, steps and resumes the processor, and reads and writes everything.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

use work.bus_pkg.all;
use work.debug_pkg.all;
use work.jtag_pkg.all;
use work.memory_pkg.all;
use work.processor_pkg.all;

entity debug_port_tb is
end entity;

architecture tb of debug_port_tb is

  type words_t is array (natural range <>) of word_t;
  constant program : words_t := (
    x"00000513",  --  0 li a0, 0
    x"00150513",  --  4 addi a0, a0, 1         loop
    x"80010437",  --  8 lui s0, 0x80010
    x"f0000337",  --  c lui t1, 0xf0000
    x"00a32023",  -- 10 sw a0, 0(t1)           a peripheral
    x"00032383",  -- 14 lw t2, 0(t1)
    x"fea42e23",  -- 18 sw a0, -4(s0)
    x"fe9ff06f",  -- 1c j loop
    x"00100073",  -- 20 ebreak
    x"10500073",  -- 24 wfi
    x"ffdff06f"); -- 28 j 24

  constant base : unsigned(31 downto 0) := x"80000000";

  signal clk : std_ulogic := '0';
  signal reset, hold, chip_reset, processor_reset : std_ulogic := '1';
  signal pins : jtag_pins_t := (tck => '0', tms => '1', tdi => '0');
  signal tdo : std_ulogic;
  signal timer_interrupt : std_ulogic := '0';
  signal to_processor : debug_request_t;
  signal from_processor : debug_response_t;
  signal instruction_request : instruction_request_t;
  signal instruction_word, data_word : word_t;
  signal processor_memory_request, memory_request : memory_request_t;
  signal processor_bus_request, bus_request : bus_request_t;
  signal processor_bus_response, bus_response : bus_response_t := bus_response_idle;
  signal bus_word : word_t := x"00000000";
  -- The debugger accesses memory only; rounds of the program's loop that were seen meanwhile.
  signal memory_only : boolean := false;
  signal rounds : natural := 0;
  -- The program is left to itself, but for halts: its numbers come one after the other.
  signal undisturbed : boolean := false;

begin

  clk <= not clk after 5 ns;
  processor_reset <= reset or hold or chip_reset;

  uut : entity work.debug_port
    port map (
      clk => clk, reset => reset, tck => pins.tck, tms => pins.tms, tdi => pins.tdi, tdo => tdo,
      chip_reset => chip_reset, processor_reset => processor_reset,
      debug_request => to_processor, debug_response => from_processor,
      processor_memory_request => processor_memory_request, memory_request => memory_request,
      memory_data => data_word,
      processor_bus_request => processor_bus_request,
      processor_bus_response => processor_bus_response,
      bus_request => bus_request, bus_response => bus_response);

  processor : entity work.processor
    port map (
      clk => clk, always_clk => clk, reset => processor_reset,
      instruction_request => instruction_request, instruction_data => instruction_word,
      memory_request => processor_memory_request, memory_data => data_word,
      bus_request => processor_bus_request, bus_response => processor_bus_response,
      timer_interrupt => timer_interrupt, external_interrupt => '0', interrupts => x"0000",
      sleeping => open, at_rest => open, retired => open, retirement => open,
      debug_request => to_processor, debug_response => from_processor);

  memory : entity work.memory
    port map (
      clk => clk, instruction_request => instruction_request, instruction_data => instruction_word,
      data_request => memory_request, data => data_word);

  -- One word on the bus; all other addresses are refused.
  peripheral : process
  begin
    wait until rising_edge(clk);
    bus_response <= bus_response_idle;
    if bus_request.strobe and not (bus_response.acknowledge or bus_response.error) then
      if bus_request.address = x"f0000000" then
        bus_response.acknowledge <= '1';
        bus_response.data <= bus_word;
        if bus_request.write then
          bus_word <= bus_request.data;
        end if;
      else
        bus_response.error <= '1';
      end if;
    end if;
  end process;

  -- Between two accesses on the bus the strobe is low, whose ever they are.
  watch_bus : process
    variable answered : std_ulogic := '0';
  begin
    wait until rising_edge(clk);
    strobe_falls_behind_an_answer : assert not (answered = '1' and bus_request.strobe = '1')
      severity failure;
    answered := bus_request.strobe and (bus_response.acknowledge or bus_response.error);
  end process;

  -- Memory accesses cost the program no clock.
  watch_times : process
    variable strobe_before : std_ulogic := '0';
    variable since, period : natural := 0;
  begin
    wait until rising_edge(clk);
    since := since + 1;
    if processor_bus_request.strobe = '1' and strobe_before = '0' and
      processor_bus_request.write = '1' then
      if memory_only then
        each_round_takes_the_same_time : assert period = 0 or since = period severity failure;
        period := since;
        rounds <= rounds + 1;
      else
        period := 0;
      end if;
      since := 0;
    end if;
    strobe_before := processor_bus_request.strobe;
  end process;

  -- Halts lose and repeat nothing.
  watch_numbers : process
    variable strobe_before : std_ulogic := '0';
    variable number, last_number : natural := 0;
  begin
    wait until rising_edge(clk);
    if processor_bus_request.strobe = '1' and strobe_before = '0' and
      processor_bus_request.write = '1' then
      number := to_integer(unsigned(processor_bus_request.data));
      numbers_follow_each_other : assert not undisturbed or number = last_number + 1
        severity failure;
      last_number := number;
    end if;
    strobe_before := processor_bus_request.strobe;
  end process;

  debug : process

    procedure write_dmi(address : std_ulogic_vector(6 downto 0); data : word_t) is
    begin
      write_dmi(pins, tdo, address, data);
    end procedure;

    procedure expect(address : std_ulogic_vector(6 downto 0); data, mask : word_t; what : string) is
      variable found : word_t;
    begin
      read_dmi(pins, tdo, address, found);
      assert (found and mask) = data
        report what & ": " & to_hstring(found and mask) & " instead of " & to_hstring(data)
        severity failure;
    end procedure;

    procedure halt is
    begin
      write_dmi(dmcontrol_address, x"80000001");
      write_dmi(dmcontrol_address, x"00000001");
      expect(dmstatus_address, x"00000300", x"00000f00", "halted");
    end procedure;

    -- The resume is acknowledged.
    procedure resume is
    begin
      write_dmi(dmcontrol_address, x"40000001");
      expect(dmstatus_address, x"00030000", x"00030000", "resumed");
    end procedure;

    procedure expect_error(error : command_error_t; what : string) is
    begin
      expect(abstractcs_address, x"00000" & '0' & error & x"01", x"ffffffff", what);
      write_dmi(abstractcs_address, x"00000700");
    end procedure;

    procedure expect_register(number : std_ulogic_vector(15 downto 0); value : word_t;
                              mask : word_t := x"ffffffff") is
    begin
      write_dmi(command_address, x"0022" & number);
      expect_error(command_error_none, "read register");
      expect(data0_address, value, mask, "register " & to_hstring(number));
    end procedure;

    procedure write_register(number : std_ulogic_vector(15 downto 0); value : word_t) is
    begin
      write_dmi(data0_address, value);
      write_dmi(command_address, x"0023" & number);
      expect_error(command_error_none, "write register");
    end procedure;

    procedure expect_memory(address : unsigned(31 downto 0); value : word_t) is
    begin
      write_dmi(sbcs_address, x"00140000");
      write_dmi(sbaddress0_address, std_ulogic_vector(address));
      expect(sbdata0_address, value, x"ffffffff", "memory " & to_hstring(address));
      expect(sbcs_address, x"00000000", x"00607000", "sberror");
    end procedure;

    -- dpc as dcsr's cause says why.
    procedure expect_halt(address : unsigned(31 downto 0); cause : natural) is
    begin
      expect(dmstatus_address, x"00000300", x"00000f00", "halted");
      expect_register(x"07b1", std_ulogic_vector(address));
      expect_register(x"07b0", std_ulogic_vector(to_unsigned(cause * 64 + 3, 32)), x"000001c3");
    end procedure;

    procedure step_to(address : natural) is
    begin
      resume;
      expect_halt(base + address, 4);
    end procedure;

    variable before : word_t;
    variable seed_1, seed_2 : positive := 5;
    variable chance : real;

  begin
    wait for 95 ns;
    reset <= '0';
    reset_tap(pins, tdo);
    scan_instruction(pins, tdo, 5x"11");
    expect(dmcontrol_address, x"00000000", x"ffffffff", "not active");
    write_dmi(dmcontrol_address, x"00000001");
    expect(dmstatus_address, x"000c30a2", x"ffffffff", "in reset");
    write_dmi(dmcontrol_address, x"ffffffc1");
    expect(dmcontrol_address, x"80000001", x"ffffffff", "one hart");

    -- The program is loaded while the processor is held before its first instruction.
    write_dmi(dmcontrol_address, x"80000001");
    hold <= '0';
    expect_halt(base, 5);
    write_dmi(dmcontrol_address, x"10000001");
    expect(dmstatus_address, x"000003a2", x"ffffffff", "halted, no reset since");
    write_dmi(sbcs_address, x"00050000");
    write_dmi(sbaddress0_address, std_ulogic_vector(base));
    for index in program'range loop
      write_dmi(sbdata0_address, program(index));
    end loop;
    for index in program'range loop
      expect_memory(base + 4 * index, program(index));
    end loop;

    -- Registers: with values at the edges of lui and addi; x8 survives writes of CSRs.
    write_register(x"1008", x"12345fff");
    write_register(x"100a", x"fffff800");
    write_register(x"101f", x"7fffffff");
    write_register(x"1000", x"55555555");
    write_register(x"0340", x"80000801");
    expect_register(x"1000", x"00000000");
    expect_register(x"1008", x"12345fff");
    expect_register(x"100a", x"fffff800");
    expect_register(x"101f", x"7fffffff");
    expect_register(x"0340", x"80000801");
    expect_register(x"0301", x"40001104", x"fff01f04");

    -- What cannot be done is refused, and harms nothing.
    write_dmi(command_address, x"00220123");
    expect_error(command_error_exception, "no such CSR");
    write_dmi(command_address, x"00230123");
    expect_error(command_error_exception, "write of no such CSR");
    expect_register(x"1008", x"12345fff");
    expect_register(x"0342", x"00000000");
    write_dmi(command_address, x"00321008");
    expect_error(command_error_not_supported, "64 bits");
    write_dmi(command_address, x"00261008");
    expect_error(command_error_not_supported, "program buffer");
    write_dmi(command_address, x"02200000");
    expect_error(command_error_not_supported, "memory");
    write_dmi(command_address, x"00221020");
    expect_error(command_error_not_supported, "floating point");

    -- abstractauto repeats the command with each access to data0.
    write_dmi(command_address, x"0022100a");
    write_dmi(abstractauto_address, x"00000001");
    write_dmi(data0_address, x"00000000");
    write_dmi(abstractauto_address, x"00000000");
    expect(data0_address, x"fffff800", x"ffffffff", "repeated");

    -- Memory by bytes and half words, and what is refused there.
    write_dmi(sbcs_address, x"00020000");
    write_dmi(sbaddress0_address, x"80001002");
    write_dmi(sbdata0_address, x"0000beef");
    write_dmi(sbcs_address, x"00000000");
    write_dmi(sbaddress0_address, x"80001001");
    write_dmi(sbdata0_address, x"000000aa");
    write_dmi(sbaddress0_address, x"80001000");
    write_dmi(sbdata0_address, x"00000055");
    expect_memory(x"80001000", x"beefaa55");
    write_dmi(sbcs_address, x"00118000");
    write_dmi(sbaddress0_address, x"80001000");
    expect(sbdata0_address, x"00000055", x"ffffffff", "byte 0");
    expect(sbdata0_address, x"000000aa", x"ffffffff", "byte 1");
    expect(sbdata0_address, x"000000ef", x"ffffffff", "byte 2");
    expect(sbdata0_address, x"000000be", x"ffffffff", "byte 3");
    write_dmi(sbcs_address, x"00120000");
    write_dmi(sbaddress0_address, x"80001002");
    expect(sbdata0_address, x"0000beef", x"ffffffff", "half word");
    write_dmi(sbaddress0_address, x"80001001");
    expect(sbcs_address, x"00003000", x"00007000", "misaligned");
    write_dmi(sbcs_address, x"00147000");
    write_dmi(sbaddress0_address, x"10000000");
    expect(sbcs_address, x"00002000", x"00007000", "nothing there");
    write_dmi(sbcs_address, x"00167000");
    write_dmi(sbaddress0_address, x"80001000");
    expect(sbcs_address, x"00004000", x"00007000", "64 bits");
    write_dmi(sbcs_address, x"00147000");

    -- Single steps: each instruction once, peripherals too.
    write_register(x"07b0", x"00008004");
    step_to(16#04#);
    step_to(16#08#);
    step_to(16#0c#);
    step_to(16#10#);
    expect_register(x"100a", x"00000001");
    step_to(16#14#);
    expect_memory(x"f0000000", x"00000001");
    step_to(16#18#);
    expect_register(x"1007", x"00000001");
    step_to(16#1c#);
    expect_memory(x"8000fffc", x"00000001");
    step_to(16#04#);

    -- A trigger halts before its instruction is executed, a step leaves it.
    write_register(x"07a0", x"00000001");
    write_register(x"07a1", x"28001044");
    expect_register(x"07a1", x"28001044");
    write_register(x"07a2", x"80000018");
    write_register(x"07a0", x"00000004");
    expect_register(x"07a0", x"00000001");
    write_register(x"07b0", x"00008000");
    resume;
    expect_halt(base + 16#18#, 2);
    expect_memory(x"8000fffc", x"00000001");
    write_register(x"07a1", x"00000000");

    -- While it runs, memory and peripherals can be read and written, and registers cannot.
    resume;
    expect(dmstatus_address, x"00000c00", x"00000f00", "running");
    write_dmi(command_address, x"0022100a");
    expect_error(command_error_not_halted, "running");
    for round in 1 to 8 loop
      write_dmi(sbaddress0_address, x"f0000000");
      read_dmi(pins, tdo, sbdata0_address, before);
      write_dmi(sbaddress0_address, x"8000fffc");
      expect(sbcs_address, x"00000000", x"00607000", "sberror");
      read_dmi(pins, tdo, sbdata0_address, before);
    end loop;
    assert unsigned(before) > 10 report "it does not run" severity failure;
    wait for 1 us;
    memory_only <= true;
    for round in 1 to 8 loop
      write_dmi(sbcs_address, x"00040000");
      write_dmi(sbaddress0_address, x"80001004");
      write_dmi(sbdata0_address, std_ulogic_vector(to_unsigned(round, 32)));
      expect_memory(x"80001004", std_ulogic_vector(to_unsigned(round, 32)));
    end loop;
    memory_only <= false;
    assert rounds > 100 report "the program stands" severity failure;

    -- A breakpoint put into the running program.
    write_dmi(sbaddress0_address, x"8000001c");
    write_dmi(sbdata0_address, program(8));
    expect_halt(base + 16#1c#, 1);
    write_dmi(sbaddress0_address, x"8000001c");
    write_dmi(sbdata0_address, program(7));
    resume;
    halt;
    expect_register(x"07b0", x"000000c3", x"000001c3");

    -- Halts at any moment, in the middle of accesses too.
    undisturbed <= true;
    for halts in 1 to 40 loop
      resume;
      uniform(seed_1, seed_2, chance);
      wait for 1 ns * integer(chance * 200.0);
      halt;
    end loop;
    undisturbed <= false;

    -- Asleep: a request halts before the wfi, a step goes over it, an interrupt waits for the end of both.
    write_register(x"07b1", x"80000024");
    resume;
    wait for 1 us;
    halt;
    expect_register(x"07b1", x"80000024");
    write_register(x"0304", x"00000080");
    write_register(x"0305", x"80000020");
    write_register(x"0300", x"00000008");
    timer_interrupt <= '1';
    write_register(x"07b0", x"00008004");
    step_to(16#28#);
    expect_register(x"0344", x"00000080");
    write_register(x"07b0", x"00008000");
    resume;
    expect_halt(base + 16#20#, 1);
    expect_register(x"0342", x"80000007");
    expect_register(x"0341", x"80000028");
    timer_interrupt <= '0';

    -- A step into an access that nothing answers ends at the handler. A trigger behind such an access is
    -- not reached.
    for access_address in 4 to 5 loop
      write_register(x"1006", x"10000000");
      write_register(x"07b1", std_ulogic_vector(base + 4 * access_address));
      write_register(x"07b0", x"00008004");
      step_to(16#20#);
      expect_register(x"0342", std_ulogic_vector(to_unsigned(7 - 2 * (access_address mod 2), 32)));
      expect_register(x"0341", std_ulogic_vector(base + 4 * access_address));
      expect_register(x"0343", x"10000000");
      write_register(x"07b0", x"00008000");
      write_register(x"07a1", x"28001044");
      write_register(x"07a2", std_ulogic_vector(base + 4 * access_address + 4));
      write_register(x"07b1", std_ulogic_vector(base + 4 * access_address));
      resume;
      expect_halt(base + 16#20#, 1);
      write_register(x"07a1", x"00000000");
    end loop;

    -- Without ebreakm an ebreak traps, here to itself.
    write_register(x"07b0", x"00000000");
    resume;
    wait for 1 us;
    halt;
    expect_register(x"0342", x"00000003");
    expect_register(x"07b1", x"80000020");

    -- Reset of the chip with and without a halt behind it.
    write_dmi(dmcontrol_address, x"00000003");
    expect(dmstatus_address, x"00003000", x"00003f00", "in reset");
    write_dmi(dmcontrol_address, x"0000000b");
    write_dmi(dmcontrol_address, x"00000001");
    expect(dmstatus_address, x"000c0000", x"000c0000", "has been reset");
    expect_halt(base, 5);
    write_dmi(dmcontrol_address, x"00000007");
    write_dmi(dmcontrol_address, x"00000001");
    write_dmi(dmcontrol_address, x"10000001");
    expect(dmstatus_address, x"00000c00", x"000c0f00", "running");
    report "debug_port_tb passed";
    std.env.finish;
  end process;

end architecture;
