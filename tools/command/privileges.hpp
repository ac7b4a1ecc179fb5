// SPDX-License-Identifier: Apache-2.0
// Programs that other machines reach do not run as root.
#pragma once

#include <string>

namespace command {

// This process becomes this user with its groups, for good; to be called before other threads are
// made. Throws std::runtime_error where there is no such user, it is root, or this process may not.
void become_user(const std::string& user);

bool is_root();

}  // namespace command
