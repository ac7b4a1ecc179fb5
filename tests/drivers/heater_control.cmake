# SPDX-License-Identifier: Apache-2.0
add_verilated_model(heater_control_model TOP heater_control)
add_unit_test(heater_control_driver_test SOURCES heater_control_test.cpp
  LIBRARIES firmware_drivers verilated_bus heater_control_model LABELS driver)
