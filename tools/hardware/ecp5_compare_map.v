// SPDX-License-Identifier: Apache-2.0
// Yosys: a comparison with a constant becomes gates. Otherwise it would take a carry chain, which has
// more delay than the two or three levels of gates of a decoder or a test for a small number.
// Of up to four bits, synth_ecp5 makes a single table; comparisons of two variables stay as they are.
(* techmap_celltype = "$lt $le $gt $ge" *)
module compare_with_constant (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;

  parameter _TECHMAP_CELLTYPE_ = "";
  parameter _TECHMAP_CONSTMSK_A_ = 0;
  parameter _TECHMAP_CONSTMSK_B_ = 0;

  localparam width = A_WIDTH > B_WIDTH ? A_WIDTH : B_WIDTH;
  wire _TECHMAP_FAIL_ = width <= 4 || !(&_TECHMAP_CONSTMSK_A_ || &_TECHMAP_CONSTMSK_B_);

  localparam is_signed = A_SIGNED && B_SIGNED;
  wire [width-1:0] a = {{width{is_signed && A[A_WIDTH-1]}}, A};
  wire [width-1:0] b = {{width{is_signed && B[B_WIDTH-1]}}, B};
  // With the sign inverted, two's complement has the order of unsigned numbers.
  wire [width-1:0] sign = is_signed << (width - 1);

  // From the lowest bit up: whether `one` is less than `other` so far.
  localparam swapped = _TECHMAP_CELLTYPE_ == "$gt" || _TECHMAP_CELLTYPE_ == "$le";
  wire [width-1:0] one = (swapped ? b : a) ^ sign;
  wire [width-1:0] other = (swapped ? a : b) ^ sign;
  wire [width:0] less;
  assign less = {(~one & other) | (~(one ^ other) & less[width-1:0]), 1'b0};
  assign Y = less[width] ^ (_TECHMAP_CELLTYPE_ == "$ge" || _TECHMAP_CELLTYPE_ == "$le");
endmodule
