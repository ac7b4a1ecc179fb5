// SPDX-License-Identifier: Apache-2.0
// In place of rtl/memory/memory.vhd on a Cyclone: the same ports, banks and clocks, of the vendor's block RAM. Quartus takes
// its contents from bank1_lane1.mif to bank3_lane4.mif, and new ones without a new synthesis.
module memory #(
  // Of at most three binary digits 1, each of which is a bank.
  parameter size_bytes = 106496
) (
  input clk,
  input instruction_request_enable,
  input [29:0] instruction_request_upper_address,
  input [29:0] instruction_request_lower_address,
  // Not used: the banks are found here.
  input [7:0] instruction_request_upper_elsewhere,
  input [7:0] instruction_request_lower_elsewhere,
  input data_request_enable,
  input [3:0] data_request_write_bytes,
  input [29:0] data_request_address,
  input [31:0] data_request_data,
  output [31:0] instruction_data,
  output [31:0] data
);

  // The place of the highest binary digit 1.
  function integer highest_in(input integer number);
    for (highest_in = 0; (2 << highest_in) <= number; highest_in = highest_in + 1) begin
    end
  endfunction

  // As many bits as the addresses of words have in each bank, and what is left after it.
  localparam bits1 = highest_in(size_bytes) - 2;
  localparam after1 = size_bytes - (4 << bits1);
  localparam bits2 = after1 == 0 ? 1 : highest_in(after1) - 2;
  localparam after2 = after1 == 0 ? 0 : after1 - (4 << bits2);
  localparam bits3 = after2 == 0 ? 1 : highest_in(after2) - 2;

  // The request is for a bank after the first, after the second; and what is shown.
  wire data_after1 = after1 != 0 && data_request_address[bits1];
  wire data_after2 = after2 != 0 && data_after1 && data_request_address[bits2];
  reg upper_shown_after1, lower_shown_after1, data_shown_after1;
  reg upper_shown_after2, lower_shown_after2, data_shown_after2;
  wire [31:0] instruction1, instruction2, instruction3, data1, data2, data3;

  memory_bank #(
    .address_bits(bits1),
    .lane1("bank1_lane1.mif"), .lane2("bank1_lane2.mif"), .lane3("bank1_lane3.mif"), .lane4("bank1_lane4.mif")
  ) bank1 (
    .clk(clk),
    .instruction_enable(instruction_request_enable),
    .upper_address(instruction_request_upper_address[bits1 - 1:0]),
    .lower_address(instruction_request_lower_address[bits1 - 1:0]),
    .instruction(instruction1),
    .data_enable(data_request_enable),
    .data_write(data_after1 ? 4'b0 : data_request_write_bytes),
    .data_address(data_request_address[bits1 - 1:0]),
    .data_in(data_request_data),
    .data_out(data1)
  );

  generate
    if (after1 != 0) begin : second
      memory_bank #(
        .address_bits(bits2),
        .lane1("bank2_lane1.mif"), .lane2("bank2_lane2.mif"), .lane3("bank2_lane3.mif"), .lane4("bank2_lane4.mif")
      ) bank2 (
        .clk(clk),
        .instruction_enable(instruction_request_enable),
        .upper_address(instruction_request_upper_address[bits2 - 1:0]),
        .lower_address(instruction_request_lower_address[bits2 - 1:0]),
        .instruction(instruction2),
        .data_enable(data_request_enable),
        .data_write(data_after1 && !data_after2 ? data_request_write_bytes : 4'b0),
        .data_address(data_request_address[bits2 - 1:0]),
        .data_in(data_request_data),
        .data_out(data2)
      );
    end else begin : no_second
      assign instruction2 = 32'b0;
      assign data2 = 32'b0;
    end

    if (after2 != 0) begin : third
      memory_bank #(
        .address_bits(bits3),
        .lane1("bank3_lane1.mif"), .lane2("bank3_lane2.mif"), .lane3("bank3_lane3.mif"), .lane4("bank3_lane4.mif")
      ) bank3 (
        .clk(clk),
        .instruction_enable(instruction_request_enable),
        .upper_address(instruction_request_upper_address[bits3 - 1:0]),
        .lower_address(instruction_request_lower_address[bits3 - 1:0]),
        .instruction(instruction3),
        .data_enable(data_request_enable),
        .data_write(data_after2 ? data_request_write_bytes : 4'b0),
        .data_address(data_request_address[bits3 - 1:0]),
        .data_in(data_request_data),
        .data_out(data3)
      );
    end else begin : no_third
      assign instruction3 = 32'b0;
      assign data3 = 32'b0;
    end
  endgenerate

  always @(posedge clk) begin
    if (instruction_request_enable) begin
      upper_shown_after1 <= after1 != 0 && instruction_request_upper_address[bits1];
      lower_shown_after1 <= after1 != 0 && instruction_request_lower_address[bits1];
      upper_shown_after2 <= after2 != 0 && instruction_request_upper_address[bits2];
      lower_shown_after2 <= after2 != 0 && instruction_request_lower_address[bits2];
    end
    if (data_request_enable) begin
      data_shown_after1 <= after1 != 0 && data_request_address[bits1];
      data_shown_after2 <= after2 != 0 && data_request_address[bits2];
    end
  end

  assign instruction_data[31:16] = !upper_shown_after1 ? instruction1[31:16] :
                                   !upper_shown_after2 ? instruction2[31:16] : instruction3[31:16];
  assign instruction_data[15:0] = !lower_shown_after1 ? instruction1[15:0] :
                                  !lower_shown_after2 ? instruction2[15:0] : instruction3[15:0];
  assign data = !data_shown_after1 ? data1 : !data_shown_after2 ? data2 : data3;

endmodule
