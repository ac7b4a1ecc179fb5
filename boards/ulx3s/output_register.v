// SPDX-License-Identifier: Apache-2.0
// The last register before an output, in the pad of the pin itself: from clock to pin it takes the same time in every
// layout. In Verilog, next to the VHDL: only Yosys needs to know the vendor's cells.
module output_register (
  input clk,
  input level,
  // `level` a clock later; low after configuration.
  output pin
);

  OFS1P3DX register (.SCLK(clk), .SP(1'b1), .CD(1'b0), .D(level), .Q(pin));

endmodule

// The same, high after configuration.
module output_register_high (
  input clk,
  input level,
  output pin
);

  OFS1P3BX register (.SCLK(clk), .SP(1'b1), .PD(1'b0), .D(level), .Q(pin));

endmodule
