// SPDX-License-Identifier: Apache-2.0
// The memory of boards/cyclone shows what that of rtl/memory shows, whenever that is defined, in random requests.
module memory_pair;

  bit clk = 0;
  bit instruction_enable, data_enable;
  bit [3:0] write_bytes;
  bit [29:0] upper_address, lower_address, data_address;
  bit [31:0] data_in;
  logic [31:0] wanted_instruction, wanted_data, instruction, data;
  // Of what the ports show: the last request was a read, and no byte of it was written in the same clock.
  bit instruction_is_defined, data_is_defined;
  int reads, writes;

  // The banks that do not hold a word. They lie behind each other, each as large as a binary digit 1 of the size, the largest first.
  function automatic bit [7:0] elsewhere(bit [29:0] word);
    int unsigned first = 0;
    bit [7:0] bank = 1;
    for (int place = 29; place >= 0; place--) begin
      if (((`SIZE_BYTES / 4) >> place) % 2 == 1) begin
        first += 1 << place;
        if (word < first) return instruction_enable ? ~bank : 8'b0;
        bank <<= 1;
      end
    end
    return 8'b0;
  endfunction

  memory_of_rtl wanted (
    .clk(clk), .instruction_request_enable(instruction_enable),
    .instruction_request_upper_address(upper_address), .instruction_request_lower_address(lower_address),
    .instruction_request_upper_elsewhere(elsewhere(upper_address)),
    .instruction_request_lower_elsewhere(elsewhere(lower_address)),
    .data_request_enable(data_enable), .data_request_write_bytes(write_bytes),
    .data_request_address(data_address), .data_request_data(data_in),
    .instruction_data(wanted_instruction), .data(wanted_data));
  memory #(.size_bytes(`SIZE_BYTES)) found (
    .clk(clk), .instruction_request_enable(instruction_enable),
    .instruction_request_upper_address(upper_address), .instruction_request_lower_address(lower_address),
    .instruction_request_upper_elsewhere(elsewhere(upper_address)),
    .instruction_request_lower_elsewhere(elsewhere(lower_address)),
    .data_request_enable(data_enable), .data_request_write_bytes(write_bytes),
    .data_request_address(data_address), .data_request_data(data_in),
    .instruction_data(instruction), .data(data));


  task automatic one_clock(bit fill, int word);
    instruction_enable = !fill && $urandom_range(3) != 0;
    data_enable = fill || $urandom_range(3) != 0;
    write_bytes = fill ? 4'hf : $urandom_range(2) == 0 ? 4'($urandom_range(15)) : 4'h0;
    data_address = fill ? 30'(word) : 30'($urandom_range(`SIZE_BYTES / 4 - 1));
    upper_address = 30'($urandom_range(`SIZE_BYTES / 4 - 1));
    lower_address = 30'($urandom_range(`SIZE_BYTES / 4 - 1));
    data_in = $urandom;
    #5 clk = 1;
    #5 clk = 0;
    if (data_enable) data_is_defined = write_bytes == 0;
    if (instruction_enable) begin
      instruction_is_defined = !(data_enable && write_bytes != 0 &&
                                 (data_address == upper_address || data_address == lower_address));
    end
    if (instruction_is_defined && instruction !== wanted_instruction) $fatal(1, "other instructions are read");
    if (data_is_defined && data !== wanted_data) $fatal(1, "other data is read");
    reads += int'(data_enable && write_bytes == 0);
    writes += int'(data_enable && write_bytes != 0);
  endtask

  initial begin
    for (int word = 0; word < `SIZE_BYTES / 4; word++) one_clock(1, word);
    for (int i = 0; i < 200_000; i++) one_clock(0, 0);
    if (reads < 50_000 || writes < 20_000) $fatal(1, "too little was tried");
    $display("memory_pair passed");
    $finish;
  end

endmodule
