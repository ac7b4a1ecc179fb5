// SPDX-License-Identifier: Apache-2.0
// Keeps the processor busy with a mix of work, as the measure of the simulation's speed.
#include "tohost.h"

static unsigned table[64];

static unsigned checksum(unsigned value) {
  for (unsigned bit = 0; bit < 8; ++bit) {
    value = (value & 1) != 0 ? (value >> 1) ^ 0xedb88320u : value >> 1;
  }
  return value;
}

int main(void) {
  unsigned state = 1;
  for (unsigned round = 0; round < 20000; ++round) {
    for (unsigned index = 0; index < 64; ++index) {
      state = state * 1664525u + 1013904223u;
      table[index] = checksum(table[(index + 7) & 63] ^ (state >> 16));
    }
  }
  tohost = 1;
  return (int)(state / 3);
}
