// SPDX-License-Identifier: Apache-2.0
// Products of every kind that a Cyclone's multiplier makes.
module products (
  input [17:0] a,
  input [17:0] b,
  input [32:0] c,
  input [32:0] d,
  output [35:0] of_unsigned,
  output [35:0] of_signed,
  output [35:0] of_both,
  output [17:0] of_9_bits,
  output [65:0] of_33_bits
);

  assign of_unsigned = a * b;
  assign of_signed = $signed(a) * $signed(b);
  assign of_both = $signed(a) * $signed({1'b0, b[16:0]});
  assign of_9_bits = $signed(a[8:0]) * $signed(b[8:0]);
  assign of_33_bits = $signed(c) * $signed(d);

endmodule
