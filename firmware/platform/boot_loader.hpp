// SPDX-License-Identifier: Apache-2.0
// The jump from the program into the boot loader.
#pragma once

namespace platform {

// Does not return where the loader is in memory, false where it is not. Motion is stopped and heat
// is off from then on; the serial line keeps its speed.
[[nodiscard]] bool enter_boot_loader();

}  // namespace platform
