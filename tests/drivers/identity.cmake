# SPDX-License-Identifier: Apache-2.0
add_verilated_model(identity_model TOP identity)
add_unit_test(identity_driver_test SOURCES identity_test.cpp
  LIBRARIES firmware_drivers verilated_bus identity_model LABELS driver)
target_compile_definitions(identity_driver_test PRIVATE PROJECT_VERSION="${PROJECT_VERSION}")
