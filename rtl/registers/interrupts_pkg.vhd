-- SPDX-License-Identifier: Apache-2.0
-- Numbers of the interrupts. Generated from the descriptions of the peripherals: do not edit.

package interrupts_pkg is

  -- The deadline has been reached.
  constant timer_interrupt_number : natural := 7;

  -- Received bytes wait: as many as the threshold, or a whole line.
  constant uart_receive_interrupt_number : natural := 16;

  -- The queue holds at most control.queue_threshold segments.
  constant queue_threshold_interrupt_number : natural := 17;

  -- A stop waits for its acknowledgement.
  constant motion_stopped_interrupt_number : natural := 18;

  -- A channel is tripped, or something opened the supply.
  constant heater_trip_interrupt_number : natural := 19;

  -- There is room for as many bytes as the threshold.
  constant uart_transmit_interrupt_number : natural := 20;

end package;
