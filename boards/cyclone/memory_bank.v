// SPDX-License-Identifier: Apache-2.0
// A bank of the memory: four lanes of bytes, with the same ports and clocks as the memory.
module memory_bank #(
  parameter address_bits = 14,
  // Files in Quartus' project.
  parameter lane1 = "bank1_lane1.mif",
  parameter lane2 = "bank1_lane2.mif",
  parameter lane3 = "bank1_lane3.mif",
  parameter lane4 = "bank1_lane4.mif"
) (
  input clk,
  input instruction_enable,
  input [address_bits - 1:0] upper_address,
  input [address_bits - 1:0] lower_address,
  output [31:0] instruction,
  input data_enable,
  input [3:0] data_write,
  input [address_bits - 1:0] data_address,
  input [31:0] data_in,
  output [31:0] data_out
);

  genvar lane;
  generate
    for (lane = 0; lane < 4; lane = lane + 1) begin : lanes
      memory_lane #(
        .address_bits(address_bits),
        .contents(lane == 0 ? lane1 : lane == 1 ? lane2 : lane == 2 ? lane3 : lane4)
      ) bytes (
        .clk(clk),
        .instruction_enable(instruction_enable),
        // An upper half word is in the last two.
        .instruction_address(lane < 2 ? lower_address : upper_address),
        .instruction(instruction[8 * lane + 7 -: 8]),
        .data_enable(data_enable),
        .data_write(data_write[lane]),
        .data_address(data_address),
        .data_in(data_in[8 * lane + 7 -: 8]),
        .data_out(data_out[8 * lane + 7 -: 8])
      );
    end
  endgenerate

endmodule
