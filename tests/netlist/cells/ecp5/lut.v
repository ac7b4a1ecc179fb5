// SPDX-License-Identifier: Apache-2.0
// The ECP5's look-up tables: each combination of the inputs picks a bit.
module LUT4 #(
  parameter [15:0] INIT = 16'b0
) (
  input A, B, C, D,
  output Z
);

  assign Z = INIT[{D, C, B, A}];

endmodule

module LUT2 #(
  parameter [3:0] INIT = 4'b0
) (
  input A, B,
  output Z
);

  assign Z = INIT[{B, A}];

endmodule
