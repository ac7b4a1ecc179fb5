// SPDX-License-Identifier: Apache-2.0
// The look-up table of a Cyclone IV E without its carry, which Yosys does not use: each combination of the inputs picks a bit.
module cycloneive_lcell_comb #(
  parameter [15:0] lut_mask = 16'b0,
  parameter sum_lutc_input = "cin"
) (
  input dataa, datab, datac, datad,
  output combout
);

  initial
    if (sum_lutc_input != "datac")
      $fatal(1, "%m: a look-up table in a way that this model does not know");

  assign combout = lut_mask[{datad, datac, datab, dataa}];

endmodule
