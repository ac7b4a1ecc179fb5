// SPDX-License-Identifier: Apache-2.0
// Yosys' names for block RAM and multipliers of a Cyclone, into cells whose ports it knows (cyclone_cells.v).
module \$__CYCLONE_BLOCK_RAM_ (
  PORT_W_CLK, PORT_W_WR_EN, PORT_W_ADDR, PORT_W_WR_DATA, PORT_R_CLK, PORT_R_RD_EN, PORT_R_ADDR, PORT_R_RD_DATA
);
  parameter PORT_W_WIDTH = 9;
  parameter PORT_R_WIDTH = 9;
  input PORT_W_CLK, PORT_W_WR_EN, PORT_R_CLK, PORT_R_RD_EN;
  input [12:0] PORT_W_ADDR, PORT_R_ADDR;
  input [PORT_W_WIDTH - 1:0] PORT_W_WR_DATA;
  output [PORT_R_WIDTH - 1:0] PORT_R_RD_DATA;
  cyclone_block_ram #(.write_width(PORT_W_WIDTH), .read_width(PORT_R_WIDTH)) _TECHMAP_REPLACE_ (
    .write_clk(PORT_W_CLK), .write_enable(PORT_W_WR_EN), .write_address(PORT_W_ADDR), .write_data(PORT_W_WR_DATA),
    .read_clk(PORT_R_CLK), .read_enable(PORT_R_RD_EN), .read_address(PORT_R_ADDR), .read_data(PORT_R_RD_DATA));
endmodule

module \$__MUL18X18 (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 18;
  parameter B_WIDTH = 18;
  parameter Y_WIDTH = 36;
  input [A_WIDTH - 1:0] A;
  input [B_WIDTH - 1:0] B;
  output [Y_WIDTH - 1:0] Y;
  cyclone_multiplier #(.a_width(A_WIDTH), .b_width(B_WIDTH), .y_width(Y_WIDTH), .a_signed(A_SIGNED),
    .b_signed(B_SIGNED)) _TECHMAP_REPLACE_ (.a(A), .b(B), .y(Y));
endmodule

module \$__MUL9X9 (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 9;
  parameter B_WIDTH = 9;
  parameter Y_WIDTH = 18;
  input [A_WIDTH - 1:0] A;
  input [B_WIDTH - 1:0] B;
  output [Y_WIDTH - 1:0] Y;
  cyclone_multiplier #(.a_width(A_WIDTH), .b_width(B_WIDTH), .y_width(Y_WIDTH), .a_signed(A_SIGNED),
    .b_signed(B_SIGNED)) _TECHMAP_REPLACE_ (.a(A), .b(B), .y(Y));
endmodule
