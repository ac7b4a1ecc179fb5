// SPDX-License-Identifier: Apache-2.0
// The one instance, kept in the image although nothing in it reads the symbol.
#include "application/statistics.hpp"

extern "C" {
[[gnu::used]] constinit application::Statistics statistics{};
}
