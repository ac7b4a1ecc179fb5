// SPDX-License-Identifier: Apache-2.0
// In a co-simulated ULX3S in the place of its cells: the reference is the clock; the simulation sets the oscillator's level.
module clock_50mhz (
  input clk_25mhz,
  output clk,
  output locked
);
  reg [7:0] passed = 0;
  always @(posedge clk_25mhz) passed <= {passed[6:0], 1'b1};
  assign clk = clk_25mhz;
  assign locked = passed[7];
endmodule

module internal_oscillator (
  output clk
);
  reg level /*verilator public_flat_rw*/ = 0;
  assign clk = level;
endmodule

module output_register (
  input clk,
  input level,
  output pin
);
  reg held = 0;
  always @(posedge clk) held <= level;
  assign pin = held;
endmodule

module output_register_high (
  input clk,
  input level,
  output pin
);
  reg held = 1;
  always @(posedge clk) held <= level;
  assign pin = held;
endmodule
