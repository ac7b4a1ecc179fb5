// SPDX-License-Identifier: Apache-2.0
// Groups first, then the user: afterwards neither can be changed.
#include "tools/command/privileges.hpp"

#include <grp.h>
#include <pwd.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace command {

bool is_root() { return geteuid() == 0; }

void become_user(const std::string& user) {
  const passwd* entry = getpwnam(user.c_str());
  if (entry == nullptr) throw std::runtime_error("there is no user " + user);
  if (entry->pw_uid == 0) throw std::runtime_error("the user " + user + " is root");
  if (geteuid() == entry->pw_uid) return;
  if (initgroups(entry->pw_name, entry->pw_gid) != 0 || setgid(entry->pw_gid) != 0 ||
      setuid(entry->pw_uid) != 0) {
    throw std::runtime_error("cannot become the user " + user + ": " +
                             std::generic_category().message(errno));
  }
  if (setuid(0) == 0) throw std::runtime_error("root was not given up");
  setenv("HOME", entry->pw_dir, 1);
}

}  // namespace command
