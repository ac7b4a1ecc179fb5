// SPDX-License-Identifier: Apache-2.0
// A netlist of a Cyclone's multipliers gives the products of products.v, of random factors and of those at the ends of their
// ranges.
module multiplier_pair;

  bit [17:0] a, b;
  bit [32:0] c, d;
  wire [35:0] wanted_unsigned, wanted_signed, wanted_mixed, found_unsigned, found_signed, found_mixed;
  wire [17:0] wanted_narrow, found_narrow;
  wire [65:0] wanted_wide, found_wide;

  products_of_source wanted (
    .a(a), .b(b), .c(c), .d(d), .of_unsigned(wanted_unsigned), .of_signed(wanted_signed), .of_both(wanted_mixed),
    .of_9_bits(wanted_narrow), .of_33_bits(wanted_wide));
  products found (
    .a(a), .b(b), .c(c), .d(d), .of_unsigned(found_unsigned), .of_signed(found_signed), .of_both(found_mixed),
    .of_9_bits(found_narrow), .of_33_bits(found_wide));

  function automatic bit [32:0] factor;
    case ($urandom_range(4))
      0: factor = 0;
      1: factor = '1;
      2: factor = 33'h1_0002_0100;  // a sign alone, of each width
      default: factor = {$urandom, 1'($urandom)};
    endcase
  endfunction

  initial begin
    repeat (100_000) begin
      a = 18'(factor());
      b = 18'(factor());
      c = factor();
      d = factor();
      #1;
      if (found_unsigned !== wanted_unsigned) $fatal(1, "another product without a sign");
      if (found_signed !== wanted_signed) $fatal(1, "another product with signs");
      if (found_mixed !== wanted_mixed) $fatal(1, "another product of both kinds");
      if (found_narrow !== wanted_narrow) $fatal(1, "another product of 9 bits");
      if (found_wide !== wanted_wide) $fatal(1, "another product of several multipliers");
    end
    $display("multiplier_pair passed");
    $finish;
  end

endmodule
