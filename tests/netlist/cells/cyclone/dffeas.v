// SPDX-License-Identifier: Apache-2.0
// The register of a Cyclone as Yosys uses it: data and enable only, its value after configuration by `power_up`; anything
// else is an error. (Yosys' own model has no enable.)
module dffeas #(
  parameter power_up = "dontcare",
  parameter is_wysiwyg = "FALSE"
) (
  input d, clk, clrn, prn, ena, asdata, aload, sclr, sload,
  output reg q
);

  initial begin
    q = power_up == "high";
    if ((power_up != "low" && power_up != "high") || is_wysiwyg != "TRUE")
      $fatal(1, "%m: a register in a way that this model does not know");
  end

  always @(posedge clk) begin
    if (!clrn || !prn || asdata || aload || sclr || sload)
      $fatal(1, "%m: a clear, preset or load that this model does not know");
    if (ena) q <= d;
  end

endmodule
