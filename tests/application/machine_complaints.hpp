// SPDX-License-Identifier: Apache-2.0
// What the machine generator says of a description with a mistake.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "directories.hpp"
#include "machine_generator/header.hpp"
#include "machine_generator/reader.hpp"
#include "tests/sim/changed_description.hpp"
#include "tools/files/file_text.hpp"

namespace application_test {

// The error for the default machine with one text replaced by another.
inline std::string complaint(const std::string& from, const std::string& to) {
  return tests::complaint_of(machine_generator::header_of, tests::changed_description(from, to));
}

// A machine of the project with one text replaced by another.
inline std::string complaint_about(const std::string& machine, const std::string& from,
                                   const std::string& to) {
  std::string text = files::text_of(PROJECT_DIRECTORY "/firmware/machines/" + machine);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return tests::complaint_of(machine_generator::header_of, text.replace(at, from.size(), to));
}

}  // namespace application_test
