// SPDX-License-Identifier: Apache-2.0
// The oscillator inside the ECP5; its level comes from the test, which has the only time.
module OSCG #(
  parameter integer DIV = 128
) (
  output OSC
);

  initial
    if (DIV != 128)
      $fatal(1, "%m: an oscillator in a way that this model does not know");

  reg level /* verilator public_flat_rw */ = 0;
  assign OSC = level;

endmodule
