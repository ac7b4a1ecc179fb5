# SPDX-License-Identifier: Apache-2.0
add_verilated_model(uart_model TOP uart)
add_unit_test(uart_driver_test SOURCES uart_test.cpp uart_interrupt_test.cpp
  LIBRARIES firmware_drivers verilated_bus uart_model LABELS driver)
