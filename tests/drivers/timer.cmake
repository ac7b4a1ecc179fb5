# SPDX-License-Identifier: Apache-2.0
add_verilated_model(timer_model TOP timer)
add_unit_test(timer_driver_test SOURCES timer_test.cpp
  LIBRARIES firmware_drivers verilated_bus timer_model LABELS driver)
