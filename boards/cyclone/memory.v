// SPDX-License-Identifier: Apache-2.0
// In place of rtl/memory/memory.vhd on a Cyclone: the same ports and clocks, of the vendor's block RAM. Quartus takes its
// contents from lane1.mif to lane4.mif and upper_lane1.mif to upper_lane4.mif, and new ones without a new synthesis.
module memory #(
  // A power of two, or three quarters of one: then the first two thirds are one bank, the last another.
  parameter size_bytes = 98304
) (
  input clk,
  input instruction_request_enable,
  input [29:0] instruction_request_upper_address,
  input [29:0] instruction_request_lower_address,
  input data_request_enable,
  input [3:0] data_request_write_bytes,
  input [29:0] data_request_address,
  input [31:0] data_request_data,
  output [31:0] instruction_data,
  output [31:0] data
);

  function integer bits_of(input integer number);
    for (bits_of = 0; (1 << bits_of) < number; bits_of = bits_of + 1) begin
    end
  endfunction

  localparam window_bits = bits_of(size_bytes);
  localparam has_upper_bank = size_bytes != (1 << window_bits);
  // Of a word in the first bank; the addresses count words.
  localparam address_bits = has_upper_bank ? window_bits - 3 : window_bits - 2;

  // An upper half word is in lanes 3 and 4.
  wire [29:0] instruction_address [1:4];
  assign instruction_address[1] = instruction_request_lower_address;
  assign instruction_address[2] = instruction_request_lower_address;
  assign instruction_address[3] = instruction_request_upper_address;
  assign instruction_address[4] = instruction_request_upper_address;

  wire data_in_upper = has_upper_bank && data_request_address[address_bits];
  wire [31:0] bank_instruction, bank_data;

  genvar lane;
  generate
    for (lane = 1; lane <= 4; lane = lane + 1) begin : lanes
      // As text: a parameter made of a number is none for Quartus.
      memory_lane #(
        .address_bits(address_bits),
        .contents(lane == 1 ? "lane1.mif" : lane == 2 ? "lane2.mif" : lane == 3 ? "lane3.mif" : "lane4.mif")
      ) bytes (
        .clk(clk),
        .instruction_enable(instruction_request_enable),
        .instruction_address(instruction_address[lane][address_bits - 1:0]),
        .instruction(bank_instruction[8 * lane - 1 -: 8]),
        .data_enable(data_request_enable),
        .data_write(data_request_write_bytes[lane - 1] && !data_in_upper),
        .data_address(data_request_address[address_bits - 1:0]),
        .data_in(data_request_data[8 * lane - 1 -: 8]),
        .data_out(bank_data[8 * lane - 1 -: 8])
      );
    end

    if (has_upper_bank) begin : two_banks
      wire [31:0] upper_instruction, upper_data;
      reg upper_from_upper, lower_from_upper, data_from_upper;

      for (lane = 1; lane <= 4; lane = lane + 1) begin : lanes
        memory_lane #(
          .address_bits(address_bits - 1),
          .contents(lane == 1 ? "upper_lane1.mif" : lane == 2 ? "upper_lane2.mif" :
                    lane == 3 ? "upper_lane3.mif" : "upper_lane4.mif")
        ) bytes (
          .clk(clk),
          .instruction_enable(instruction_request_enable),
          .instruction_address(instruction_address[lane][address_bits - 2:0]),
          .instruction(upper_instruction[8 * lane - 1 -: 8]),
          .data_enable(data_request_enable),
          .data_write(data_request_write_bytes[lane - 1] && data_in_upper),
          .data_address(data_request_address[address_bits - 2:0]),
          .data_in(data_request_data[8 * lane - 1 -: 8]),
          .data_out(upper_data[8 * lane - 1 -: 8])
        );
      end

      always @(posedge clk) begin
        if (instruction_request_enable) begin
          upper_from_upper <= instruction_request_upper_address[address_bits];
          lower_from_upper <= instruction_request_lower_address[address_bits];
        end
        if (data_request_enable) data_from_upper <= data_in_upper;
      end

      assign instruction_data[31:16] = upper_from_upper ? upper_instruction[31:16] : bank_instruction[31:16];
      assign instruction_data[15:0] = lower_from_upper ? upper_instruction[15:0] : bank_instruction[15:0];
      assign data = data_from_upper ? upper_data : bank_data;
    end else begin : one_bank
      assign instruction_data = bank_instruction;
      assign data = bank_data;
    end
  endgenerate

endmodule
