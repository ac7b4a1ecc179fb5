// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a wish that jobs look at, so that they can still write their report.
#pragma once

namespace command {

// From now on the first SIGINT, SIGTERM or SIGHUP only sets the wish; one that comes two seconds
// later ends the program at once.
void catch_interrupts();
bool interrupt_requested();

}  // namespace command
