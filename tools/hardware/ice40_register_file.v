// SPDX-License-Identifier: Apache-2.0
// In place of rtl/processor/register_file.vhd on an iCE40, whose block RAM is read with a clock edge: with the falling
// one the values are there within the clock, as those of distributed memory. What a rising edge writes is read by
// the next falling edge.
module register_file (
  input clk,
  input [4:0] first_index,
  input [4:0] second_index,
  input write,
  input [4:0] write_index,
  input [31:0] write_data,
  output reg [31:0] first,
  output reg [31:0] second
);

  reg [31:0] words [0:31];
  integer index;
  initial for (index = 0; index < 32; index = index + 1) words[index] = 32'b0;

  always @(posedge clk) if (write) words[write_index] <= write_data;

  always @(negedge clk) begin
    first <= words[first_index];
    second <= words[second_index];
  end

endmodule
