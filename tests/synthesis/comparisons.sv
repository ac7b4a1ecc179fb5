// SPDX-License-Identifier: Apache-2.0
// Comparisons with constants, of each kind, sign and side, for check_comparisons.sh.
module comparison #(parameter width = 1, parameter constant = 0) (input [31:0] value, output [18:0] results);
  wire [width-1:0] number = value;
  wire signed [width-1:0] signed_number = value;
  localparam [width-1:0] limit = constant;
  localparam signed [width-1:0] signed_limit = constant;
  // One bit more: limits that the number cannot reach.
  localparam [width:0] wide_limit = {1'b1, limit};
  localparam signed [width:0] wide_signed_limit = {1'b1, limit};
  assign results = {
    number < limit, number <= limit, number > limit, number >= limit,
    limit < number, limit <= number, limit > number, limit >= number,
    signed_number < signed_limit, signed_number <= signed_limit,
    signed_number > signed_limit, signed_number >= signed_limit,
    signed_limit < signed_number, signed_limit <= signed_number,
    signed_limit > signed_number, signed_limit >= signed_number,
    number < wide_limit, signed_number >= wide_signed_limit, number > signed_limit};
endmodule

module comparisons (input [31:0] value, input [31:0] other, output [5 * 12 * 19 - 1:0] results, output neither);
  genvar place, index;
  generate
    for (place = 0; place < 5; place = place + 1) begin : widths
      localparam width = place < 3 ? place + 5 : place == 3 ? 12 : 32;
      // 0, 1, 2, 3 and those next to a half and to the end.
      for (index = 0; index < 12; index = index + 1) begin : limits
        localparam [31:0] half = 32'd1 << (width - 1);
        localparam [31:0] limit = index < 4 ? index : index < 8 ? half + index - 6 : index - 12;
        comparison #(.width(width), .constant(limit)) each_comparison (
          .value(value), .results(results[(12 * place + index) * 19 +: 19]));
      end
    end
  endgenerate
  // To be left to a carry chain.
  assign neither = value < other;
endmodule
