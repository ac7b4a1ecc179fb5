// SPDX-License-Identifier: Apache-2.0
// A program that fails with exit status 3.
#include "tohost.h"

int main(void) {
  tohost = 7;
  return 0;
}
