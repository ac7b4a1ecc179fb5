// SPDX-License-Identifier: Apache-2.0
// `test`: builds everything and runs the tests.
#pragma once

#include <string>
#include <vector>

namespace command {

// All tests, or those that bear one of the labels. Returns the exit status of the job.
int test(const std::vector<std::string>& labels);

}  // namespace command
