# SPDX-License-Identifier: Apache-2.0
add_verilated_model(end_stops_model TOP end_stops)
add_unit_test(end_stops_driver_test SOURCES end_stops_test.cpp
  LIBRARIES firmware_drivers verilated_bus end_stops_model LABELS driver)
