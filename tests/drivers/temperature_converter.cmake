# SPDX-License-Identifier: Apache-2.0
add_verilated_model(temperature_converter_model TOP temperature_converter)
add_unit_test(temperature_converter_driver_test SOURCES temperature_converter_test.cpp
  LIBRARIES firmware_drivers firmware_thermal simulation verilated_bus temperature_converter_model
  LABELS driver)
