// SPDX-License-Identifier: Apache-2.0
// The smallest program that passes.
#include "tohost.h"

int main(void) {
  tohost = 1;
  return 0;
}
