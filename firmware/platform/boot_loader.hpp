// SPDX-License-Identifier: Apache-2.0
// The jump from the program into the boot loader.
#pragma once

namespace platform {

// Does not return where the loader is in memory, false where it is not. Motion is stopped and heat
// is off from then on; the serial line keeps its speed.
[[nodiscard]] bool enter_boot_loader();

// Back to where the processor begins after a reset, which is in the loader: stack and variables
// become what they are then, the peripherals stay as they are. Returns as the above.
[[nodiscard]] bool restart();

}  // namespace platform
