# SPDX-License-Identifier: Apache-2.0
add_verilated_model(fan_model TOP fan)
add_unit_test(fan_driver_test SOURCES fan_test.cpp
  LIBRARIES firmware_drivers verilated_bus fan_model LABELS driver)
