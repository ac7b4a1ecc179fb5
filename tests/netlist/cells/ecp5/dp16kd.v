// SPDX-License-Identifier: Apache-2.0
// Block RAM of the ECP5, 18 kbit with two ports, as this project's netlists use it; anything else is an error.
// How bits lie in it is as in Lattice's memory usage guide for the ECP5 (FPGA-TN-02204). What that leaves open is made
// wrong on purpose: bits that one port reads in the clock in which the other writes their word are inverted, so
// that no design passes that relies on them.
module DP16KD #(
  parameter integer DATA_WIDTH_A = 18,
  parameter integer DATA_WIDTH_B = 18,
  parameter REGMODE_A = "NOREG",
  parameter REGMODE_B = "NOREG",
  // A reset clears what is shown at an edge of the clock, whether the port is enabled or not, and blocks a write; an
  // asynchronous one must be low here.
  parameter RESETMODE = "SYNC",
  parameter ASYNC_RESET_RELEASE = "SYNC",
  parameter CSDECODE_A = "0b000",
  parameter CSDECODE_B = "0b000",
  parameter WRITEMODE_A = "NORMAL",
  parameter WRITEMODE_B = "NORMAL",
  parameter CLKAMUX = "CLKA",
  parameter CLKBMUX = "CLKB",
  parameter GSR = "DISABLED",
  parameter [319:0] INITVAL_00 = 320'b0,
  parameter [319:0] INITVAL_01 = 320'b0,
  parameter [319:0] INITVAL_02 = 320'b0,
  parameter [319:0] INITVAL_03 = 320'b0,
  parameter [319:0] INITVAL_04 = 320'b0,
  parameter [319:0] INITVAL_05 = 320'b0,
  parameter [319:0] INITVAL_06 = 320'b0,
  parameter [319:0] INITVAL_07 = 320'b0,
  parameter [319:0] INITVAL_08 = 320'b0,
  parameter [319:0] INITVAL_09 = 320'b0,
  parameter [319:0] INITVAL_0A = 320'b0,
  parameter [319:0] INITVAL_0B = 320'b0,
  parameter [319:0] INITVAL_0C = 320'b0,
  parameter [319:0] INITVAL_0D = 320'b0,
  parameter [319:0] INITVAL_0E = 320'b0,
  parameter [319:0] INITVAL_0F = 320'b0,
  parameter [319:0] INITVAL_10 = 320'b0,
  parameter [319:0] INITVAL_11 = 320'b0,
  parameter [319:0] INITVAL_12 = 320'b0,
  parameter [319:0] INITVAL_13 = 320'b0,
  parameter [319:0] INITVAL_14 = 320'b0,
  parameter [319:0] INITVAL_15 = 320'b0,
  parameter [319:0] INITVAL_16 = 320'b0,
  parameter [319:0] INITVAL_17 = 320'b0,
  parameter [319:0] INITVAL_18 = 320'b0,
  parameter [319:0] INITVAL_19 = 320'b0,
  parameter [319:0] INITVAL_1A = 320'b0,
  parameter [319:0] INITVAL_1B = 320'b0,
  parameter [319:0] INITVAL_1C = 320'b0,
  parameter [319:0] INITVAL_1D = 320'b0,
  parameter [319:0] INITVAL_1E = 320'b0,
  parameter [319:0] INITVAL_1F = 320'b0,
  parameter [319:0] INITVAL_20 = 320'b0,
  parameter [319:0] INITVAL_21 = 320'b0,
  parameter [319:0] INITVAL_22 = 320'b0,
  parameter [319:0] INITVAL_23 = 320'b0,
  parameter [319:0] INITVAL_24 = 320'b0,
  parameter [319:0] INITVAL_25 = 320'b0,
  parameter [319:0] INITVAL_26 = 320'b0,
  parameter [319:0] INITVAL_27 = 320'b0,
  parameter [319:0] INITVAL_28 = 320'b0,
  parameter [319:0] INITVAL_29 = 320'b0,
  parameter [319:0] INITVAL_2A = 320'b0,
  parameter [319:0] INITVAL_2B = 320'b0,
  parameter [319:0] INITVAL_2C = 320'b0,
  parameter [319:0] INITVAL_2D = 320'b0,
  parameter [319:0] INITVAL_2E = 320'b0,
  parameter [319:0] INITVAL_2F = 320'b0,
  parameter [319:0] INITVAL_30 = 320'b0,
  parameter [319:0] INITVAL_31 = 320'b0,
  parameter [319:0] INITVAL_32 = 320'b0,
  parameter [319:0] INITVAL_33 = 320'b0,
  parameter [319:0] INITVAL_34 = 320'b0,
  parameter [319:0] INITVAL_35 = 320'b0,
  parameter [319:0] INITVAL_36 = 320'b0,
  parameter [319:0] INITVAL_37 = 320'b0,
  parameter [319:0] INITVAL_38 = 320'b0,
  parameter [319:0] INITVAL_39 = 320'b0,
  parameter [319:0] INITVAL_3A = 320'b0,
  parameter [319:0] INITVAL_3B = 320'b0,
  parameter [319:0] INITVAL_3C = 320'b0,
  parameter [319:0] INITVAL_3D = 320'b0,
  parameter [319:0] INITVAL_3E = 320'b0,
  parameter [319:0] INITVAL_3F = 320'b0
) (
  input
    DIA0, DIA1, DIA2, DIA3, DIA4, DIA5, DIA6, DIA7, DIA8, DIA9, DIA10, DIA11, DIA12, DIA13,
    DIA14, DIA15, DIA16, DIA17,
  input
    ADA0, ADA1, ADA2, ADA3, ADA4, ADA5, ADA6, ADA7, ADA8, ADA9, ADA10, ADA11, ADA12, ADA13,
  input CLKA, CEA, OCEA, WEA, RSTA, CSA0, CSA1, CSA2,
  output
    DOA0, DOA1, DOA2, DOA3, DOA4, DOA5, DOA6, DOA7, DOA8, DOA9, DOA10, DOA11, DOA12, DOA13,
    DOA14, DOA15, DOA16, DOA17,
  input
    DIB0, DIB1, DIB2, DIB3, DIB4, DIB5, DIB6, DIB7, DIB8, DIB9, DIB10, DIB11, DIB12, DIB13,
    DIB14, DIB15, DIB16, DIB17,
  input
    ADB0, ADB1, ADB2, ADB3, ADB4, ADB5, ADB6, ADB7, ADB8, ADB9, ADB10, ADB11, ADB12, ADB13,
  input CLKB, CEB, OCEB, WEB, RSTB, CSB0, CSB1, CSB2,
  output
    DOB0, DOB1, DOB2, DOB3, DOB4, DOB5, DOB6, DOB7, DOB8, DOB9, DOB10, DOB11, DOB12, DOB13,
    DOB14, DOB15, DOB16, DOB17
);

  // Each of the 64 values holds 16 words of 18 bits, 20 bits apart.
  localparam [64 * 320 - 1:0] initial_contents = {
    INITVAL_3F, INITVAL_3E, INITVAL_3D, INITVAL_3C, INITVAL_3B, INITVAL_3A, INITVAL_39,
    INITVAL_38, INITVAL_37, INITVAL_36, INITVAL_35, INITVAL_34, INITVAL_33, INITVAL_32,
    INITVAL_31, INITVAL_30, INITVAL_2F, INITVAL_2E, INITVAL_2D, INITVAL_2C, INITVAL_2B,
    INITVAL_2A, INITVAL_29, INITVAL_28, INITVAL_27, INITVAL_26, INITVAL_25, INITVAL_24,
    INITVAL_23, INITVAL_22, INITVAL_21, INITVAL_20, INITVAL_1F, INITVAL_1E, INITVAL_1D,
    INITVAL_1C, INITVAL_1B, INITVAL_1A, INITVAL_19, INITVAL_18, INITVAL_17, INITVAL_16,
    INITVAL_15, INITVAL_14, INITVAL_13, INITVAL_12, INITVAL_11, INITVAL_10, INITVAL_0F,
    INITVAL_0E, INITVAL_0D, INITVAL_0C, INITVAL_0B, INITVAL_0A, INITVAL_09, INITVAL_08,
    INITVAL_07, INITVAL_06, INITVAL_05, INITVAL_04, INITVAL_03, INITVAL_02, INITVAL_01,
    INITVAL_00
  };

  reg [17:0] words [0:1023];
  integer place;

  function known_width(input integer width);
    known_width = width == 1 || width == 2 || width == 4 || width == 9 || width == 18;
  endfunction

  initial begin
    for (place = 0; place < 1024; place = place + 1) words[place] = initial_contents[20 * place +: 18];
    if (REGMODE_A != "NOREG" || REGMODE_B != "NOREG" || CSDECODE_A != "0b000" || CSDECODE_B != "0b000" ||
        CLKAMUX != "CLKA" || CLKBMUX != "CLKB" || GSR != "DISABLED" ||
        (WRITEMODE_A != "NORMAL" && WRITEMODE_A != "READBEFOREWRITE") ||
        (WRITEMODE_B != "NORMAL" && WRITEMODE_B != "READBEFOREWRITE") ||
        !known_width(DATA_WIDTH_A) || !known_width(DATA_WIDTH_B))
      $fatal(1, "%m: a block RAM in a way that this model does not know");
  end

  // Where in its word the data of an address begins: each half has eight bits and a ninth that only the widths 9 and
  // 18 reach.
  function [4:0] lowest_bit(input integer width, input [3:0] address);
    case (width)
      1: lowest_bit = (address[3] ? 5'd9 : 5'd0) + {2'b0, address[2:0]};
      2: lowest_bit = (address[3] ? 5'd9 : 5'd0) + {2'b0, address[2:1], 1'b0};
      4: lowest_bit = (address[3] ? 5'd9 : 5'd0) + {2'b0, address[2], 2'b0};
      9: lowest_bit = address[3] ? 5'd9 : 5'd0;
      default: lowest_bit = 5'd0;
    endcase
  endfunction

  // Which bits of the word a write changes; in the widest form the lowest address bits enable the halves.
  function [17:0] written_bits(input integer width, input [3:0] address);
    case (width)
      1: written_bits = 18'h1 << lowest_bit(width, address);
      2: written_bits = 18'h3 << lowest_bit(width, address);
      4: written_bits = 18'hf << lowest_bit(width, address);
      9: written_bits = 18'h1ff << lowest_bit(width, address);
      default: written_bits = {{9{address[1]}}, {9{address[0]}}};
    endcase
  endfunction

  wire [13:0] address_a = {
    ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0
  };
  wire [17:0] given_a = {
    DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4,
    DIA3, DIA2, DIA1, DIA0
  };
  reg [17:0] shown_a = 18'b0;
  assign {
    DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5, DOA4,
    DOA3, DOA2, DOA1, DOA0
  } = shown_a;
  wire [17:0] changed_a =
    CEA && WEA && !RSTA ? written_bits(DATA_WIDTH_A, address_a[3:0]) : 18'b0;

  wire [13:0] address_b = {
    ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0
  };
  wire [17:0] given_b = {
    DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4,
    DIB3, DIB2, DIB1, DIB0
  };
  reg [17:0] shown_b = 18'b0;
  assign {
    DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5, DOB4,
    DOB3, DOB2, DOB1, DOB0
  } = shown_b;
  wire [17:0] changed_b =
    CEB && WEB && !RSTB ? written_bits(DATA_WIDTH_B, address_b[3:0]) : 18'b0;

  wire same_word = address_a[13:4] == address_b[13:4];

  always @(posedge CLKA) begin
    if ((RSTA && RESETMODE != "SYNC") || !OCEA || CSA0 || CSA1 || CSA2)
      $fatal(1, "%m: a reset, output enable or chip select that this model does not know");
    if (CEA) begin
      if (WEA)
        words[address_a[13:4]] <= (words[address_a[13:4]] & ~changed_a) |
          (given_a << lowest_bit(DATA_WIDTH_A, address_a[3:0]) & changed_a);
      if (!WEA || WRITEMODE_A == "READBEFOREWRITE")
        shown_a <= (words[address_a[13:4]] ^ (same_word ? changed_b : 18'b0)) >>
          lowest_bit(DATA_WIDTH_A, address_a[3:0]);
    end
    if (RSTA) shown_a <= 18'b0;
  end

  always @(posedge CLKB) begin
    if ((RSTB && RESETMODE != "SYNC") || !OCEB || CSB0 || CSB1 || CSB2)
      $fatal(1, "%m: a reset, output enable or chip select that this model does not know");
    if (CEB) begin
      if (WEB)
        words[address_b[13:4]] <= (words[address_b[13:4]] & ~changed_b) |
          (given_b << lowest_bit(DATA_WIDTH_B, address_b[3:0]) & changed_b);
      if (!WEB || WRITEMODE_B == "READBEFOREWRITE")
        shown_b <= (words[address_b[13:4]] ^ (same_word ? changed_a : 18'b0)) >>
          lowest_bit(DATA_WIDTH_B, address_b[3:0]);
    end
    if (RSTB) shown_b <= 18'b0;
  end

endmodule
