// SPDX-License-Identifier: Apache-2.0
// The oscillator inside the ECP5, which needs nothing of the board: 310 MHz / 128, 2.4 MHz within 15 %.
module internal_oscillator (
  output clk
);

  OSCG #(
    .DIV(128)
  ) oscillator (
    .OSC(clk)
  );

endmodule
