// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a wish that jobs look at, so that they can still write their report.
#pragma once

namespace command {

// From now on the first SIGINT or SIGTERM only sets the wish; a second one ends the program at
// once.
void catch_interrupts();
bool interrupt_requested();

}  // namespace command
