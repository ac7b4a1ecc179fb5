// SPDX-License-Identifier: Apache-2.0
// What boards/cyclone uses of the vendor's cells, for tools other than Quartus: Yosys takes the ports, a simulator the model.

module altsyncram #(
  parameter lpm_type = "altsyncram",
  parameter operation_mode = "BIDIR_DUAL_PORT",
  parameter width_a = 8,
  parameter widthad_a = 1,
  parameter numwords_a = 2,
  parameter width_b = 8,
  parameter widthad_b = 1,
  parameter numwords_b = 2,
  parameter init_file = "UNUSED",
  parameter power_up_uninitialized = "FALSE",
  parameter address_reg_b = "CLOCK1",
  parameter indata_reg_b = "CLOCK1",
  parameter wrcontrol_wraddress_reg_b = "CLOCK1",
  parameter clock_enable_input_a = "NORMAL",
  parameter clock_enable_input_b = "NORMAL",
  parameter clock_enable_output_a = "BYPASS",
  parameter clock_enable_output_b = "BYPASS",
  parameter outdata_reg_a = "UNREGISTERED",
  parameter outdata_reg_b = "UNREGISTERED",
  parameter read_during_write_mode_mixed_ports = "DONT_CARE"
) (
  input clock0,
  input clocken0,
  input [widthad_a - 1:0] address_a,
  input wren_a,
  input [width_a - 1:0] data_a,
  output reg [width_a - 1:0] q_a,
  input clock1,
  input clocken1,
  input [widthad_b - 1:0] address_b,
  input wren_b,
  input [width_b - 1:0] data_b,
  output reg [width_b - 1:0] q_b
);

`ifndef YOSYS
  reg [width_a - 1:0] words [0:numwords_a - 1];
  // Of init_file, which Quartus would look for in the project's folder and a simulation does in its own: lines of
  // "address : contents;" in hexadecimal, behind CONTENT BEGIN.
  string line;
  integer contents, place, address, value, is_inside;

  initial begin
    if (operation_mode != "BIDIR_DUAL_PORT" || width_b != width_a || numwords_b != numwords_a ||
        address_reg_b != "CLOCK1" || indata_reg_b != "CLOCK1" || wrcontrol_wraddress_reg_b != "CLOCK1" ||
        clock_enable_input_a != "NORMAL" || clock_enable_input_b != "NORMAL" || clock_enable_output_a != "BYPASS" ||
        clock_enable_output_b != "BYPASS" || outdata_reg_a != "UNREGISTERED" || outdata_reg_b != "UNREGISTERED")
      $fatal(1, "%m: a block RAM in a way that this model does not know");
    q_a = 0;
    q_b = 0;
    contents = $fopen(init_file, "r");
    if (contents == 0) $fatal(1, "%m: there is no file %s", init_file);
    is_inside = 0;
    place = 0;
    while ($fgets(line, contents) != 0) begin
      if ($sscanf(line, " %h : %h;", address, value) == 2 && is_inside != 0) begin
        if (address != place || value >> width_a != 0) $fatal(1, "%m: %s is not in the order of its addresses", init_file);
        words[place] = value[width_a - 1:0];
        place = place + 1;
      end else if (line == "CONTENT BEGIN\n") is_inside = 1;
    end
    if (place != numwords_a) $fatal(1, "%m: %s has %0d words", init_file, place);
    $fclose(contents);
  end

  // Port A is used for reading only. What it reads while port B writes the same word is undefined, so here it is wrong.
  always @(posedge clock0) begin
    if (wren_a) $fatal(1, "%m: a write that this model does not know");
    if (clocken0) q_a <= clocken1 && wren_b && address_a == address_b ? ~words[address_a] : words[address_a];
  end

  // A port that writes shows what it has written.
  always @(posedge clock1) if (clocken1) begin
    if (wren_b) words[address_b] <= data_b;
    q_b <= wren_b ? data_b : words[address_b];
  end
`endif

endmodule

// Two cells for what Yosys has no vendor's cells for (cyclone_map.v).

// Block RAM, of which one port writes and one reads, of the same width. The address counts single bits, or eighths of nine;
// its lowest bits have no meaning in a wider word. A word that is written while it is read shows what it was, as the
// device's does where both ports have one clock.
module cyclone_block_ram #(
  parameter write_width = 9,
  parameter read_width = 9
) (
  input write_clk,
  input write_enable,
  input [12:0] write_address,
  input [write_width - 1:0] write_data,
  input read_clk,
  input read_enable,
  input [12:0] read_address,
  output reg [read_width - 1:0] read_data
);

  localparam skipped_bits = read_width < 9 ? $clog2(read_width) : 3 + $clog2(read_width / 9);

  reg [read_width - 1:0] words [0:(8192 >> skipped_bits) - 1];
  integer place;

  initial begin
    read_data = 0;
    for (place = 0; place < 8192 >> skipped_bits; place = place + 1) words[place] = 0;
    if (write_width != read_width) $fatal(1, "%m: a block RAM in a way that this model does not know");
  end

  always @(posedge write_clk) if (write_enable) words[write_address[12:skipped_bits]] <= write_data;
  always @(posedge read_clk) if (read_enable) read_data <= words[read_address[12:skipped_bits]];

endmodule

// A multiplier of 18 by 18 or 9 by 9 bits without registers.
module cyclone_multiplier #(
  parameter a_width = 18,
  parameter b_width = 18,
  parameter y_width = 36,
  parameter a_signed = 0,
  parameter b_signed = 0
) (
  input [a_width - 1:0] a,
  input [b_width - 1:0] b,
  output [y_width - 1:0] y
);

  wire signed [a_width:0] left = {a_signed != 0 && a[a_width - 1], a};
  wire signed [b_width:0] right = {b_signed != 0 && b[b_width - 1], b};
  wire signed [a_width + b_width + 1:0] product = left * right;
  assign y = product[y_width - 1:0];

endmodule

// The phase-locked loop without its time: it multiplies by one, and is locked at once.
module altpll #(
  parameter intended_device_family = "Cyclone IV E",
  parameter lpm_type = "altpll",
  parameter operation_mode = "NORMAL",
  parameter compensate_clock = "CLK0",
  parameter pll_type = "AUTO",
  parameter width_clock = 5,
  parameter inclk0_input_frequency = 20000,
  parameter clk0_multiply_by = 1,
  parameter clk0_divide_by = 1,
  parameter clk0_duty_cycle = 50,
  parameter clk0_phase_shift = "0",
  parameter port_clk0 = "PORT_USED",
  parameter port_inclk0 = "PORT_USED",
  parameter port_locked = "PORT_USED"
) (
  input [1:0] inclk,
  output [width_clock - 1:0] clk,
  output locked
);

  initial
    if (clk0_multiply_by != clk0_divide_by || operation_mode != "NORMAL" || clk0_phase_shift != "0")
      $fatal(1, "%m: a phase-locked loop in a way that this model does not know");

  assign clk = {{width_clock - 1{1'b0}}, inclk[0]};
  assign locked = 1'b1;

endmodule
