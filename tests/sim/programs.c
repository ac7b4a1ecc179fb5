/* SPDX-License-Identifier: Apache-2.0 */
/* A bare-metal program that ends with EXIT_VALUE in `tohost`, or never where that is 0. */
volatile unsigned long tohost;

static int fibonacci(int n) { return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2); }

int main(void) {
  volatile int ten = 10;
  if (fibonacci(ten) * 3 / ten == 16) tohost = EXIT_VALUE;
  for (;;) {
  }
}
