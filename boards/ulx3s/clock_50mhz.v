// SPDX-License-Identifier: Apache-2.0
// The board's 25 MHz doubled by a phase-locked loop of the ECP5. In Verilog, beside the VHDL: only Yosys
// needs to know the vendor's cells.
module clock_50mhz (
  input clk_25mhz,
  output clk,
  // The clock is steady.
  output locked
);

  // The oscillator runs at 600 MHz (it may between 400 and 800): twelve times the output, which is
  // compared with twice the input.
  EHXPLLL #(
    .CLKI_DIV(1),
    .CLKFB_DIV(2),
    .CLKOP_DIV(12),
    .CLKOP_CPHASE(5),
    .CLKOP_FPHASE(0),
    .CLKOP_ENABLE("ENABLED"),
    .FEEDBK_PATH("CLKOP")
  ) phase_locked_loop (
    .CLKI(clk_25mhz),
    .CLKFB(clk),
    .CLKOP(clk),
    .LOCK(locked),
    .RST(1'b0),
    .STDBY(1'b0),
    .PHASESEL0(1'b0),
    .PHASESEL1(1'b0),
    .PHASEDIR(1'b0),
    .PHASESTEP(1'b0),
    .PHASELOADREG(1'b0),
    .PLLWAKESYNC(1'b0),
    .ENCLKOP(1'b0)
  );

endmodule
