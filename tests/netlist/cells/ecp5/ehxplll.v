// SPDX-License-Identifier: Apache-2.0
// The phase-locked loop of the ECP5 without its time: the model is clocked with the loop's output, which is locked at once.
module EHXPLLL #(
  parameter integer CLKI_DIV = 1,
  parameter integer CLKFB_DIV = 1,
  parameter integer CLKOP_DIV = 8,
  parameter integer CLKOP_CPHASE = 0,
  parameter integer CLKOP_FPHASE = 0,
  parameter CLKOP_ENABLE = "ENABLED",
  parameter FEEDBK_PATH = "CLKOP"
) (
  input CLKI, CLKFB, RST, STDBY, PHASESEL0, PHASESEL1, PHASEDIR, PHASESTEP, PHASELOADREG, PLLWAKESYNC, ENCLKOP,
  output CLKOP, LOCK
);

  initial
    if (CLKOP_ENABLE != "ENABLED" || FEEDBK_PATH != "CLKOP" || CLKOP_FPHASE != 0)
      $fatal(1, "%m: a phase-locked loop in a way that this model does not know");

  assign CLKOP = CLKI;
  assign LOCK = !RST && !STDBY;

endmodule
