// SPDX-License-Identifier: Apache-2.0
// One byte of each word of a bank, as block RAM: a port that reads instructions, and one that reads or writes data. While a
// port is not enabled it keeps what it shows.
module memory_lane #(
  parameter address_bits = 14,
  // A file in Quartus' project.
  parameter contents = "bank1_lane1.mif"
) (
  input clk,
  input instruction_enable,
  input [address_bits - 1:0] instruction_address,
  output [7:0] instruction,
  input data_enable,
  input data_write,
  input [address_bits - 1:0] data_address,
  input [7:0] data_in,
  output [7:0] data_out
);

  altsyncram #(
    .lpm_type("altsyncram"),
    .operation_mode("BIDIR_DUAL_PORT"),
    .width_a(8),
    .widthad_a(address_bits),
    .numwords_a(1 << address_bits),
    .width_b(8),
    .widthad_b(address_bits),
    .numwords_b(1 << address_bits),
    .init_file(contents),
    .power_up_uninitialized("FALSE"),
    // Each port has its own clock enable only with a clock of its own, here the same.
    .address_reg_b("CLOCK1"),
    .indata_reg_b("CLOCK1"),
    .wrcontrol_wraddress_reg_b("CLOCK1"),
    .clock_enable_input_a("NORMAL"),
    .clock_enable_input_b("NORMAL"),
    .clock_enable_output_a("BYPASS"),
    .clock_enable_output_b("BYPASS"),
    .outdata_reg_a("UNREGISTERED"),
    .outdata_reg_b("UNREGISTERED"),
    .read_during_write_mode_mixed_ports("DONT_CARE")
  ) altsyncram_component (
    .clock0(clk),
    .clocken0(instruction_enable),
    .address_a(instruction_address),
    .wren_a(1'b0),
    .data_a(8'b0),
    .q_a(instruction),
    .clock1(clk),
    .clocken1(data_enable),
    .address_b(data_address),
    .wren_b(data_write),
    .data_b(data_in),
    .q_b(data_out)
  );

endmodule
