// SPDX-License-Identifier: Apache-2.0
// The chip's clock by a phase-locked loop of the Cyclone. In Verilog, next to the VHDL: only Quartus and Yosys need to know
// the vendor's cell.
module phase_locked_loop #(
  // As Quartus calls it.
  parameter device_family = "Cyclone IV E",
  parameter reference_period_ps = 20000,
  parameter multiply = 1,
  parameter divide = 1
) (
  input reference_clk,
  output clk,
  // The clock is steady.
  output locked
);

  // A Cyclone II counts the outputs of older families.
  localparam outputs = device_family == "Cyclone II" ? 6 : 5;
  wire [outputs - 1:0] clocks;
  assign clk = clocks[0];

  altpll #(
    .intended_device_family(device_family),
    .lpm_type("altpll"),
    .operation_mode("NORMAL"),
    .compensate_clock("CLK0"),
    .pll_type("AUTO"),
    .width_clock(outputs),
    .inclk0_input_frequency(reference_period_ps),
    .clk0_multiply_by(multiply),
    .clk0_divide_by(divide),
    .clk0_duty_cycle(50),
    .clk0_phase_shift("0"),
    .port_clk0("PORT_USED"),
    .port_inclk0("PORT_USED"),
    .port_locked("PORT_USED")
  ) altpll_component (
    .inclk({1'b0, reference_clk}),
    .clk(clocks),
    .locked(locked)
  );

endmodule
