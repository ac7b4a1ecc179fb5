// SPDX-License-Identifier: Apache-2.0
// A socket that systemd has opened (socket activation, sd_listen_fds(3)).
#pragma once

#include <optional>

#include "host/web/address.hpp"

namespace web {

// Owned by who made this process: it listens on after the end of a server that has used it.
struct InheritedSocket {
  int number{};
  Address address{};
};

// Nothing where the environment has none for this process (LISTEN_PID, LISTEN_FDS). Programs that
// are started later inherit neither socket nor variables. Throws std::runtime_error where it is not
// one TCP socket that listens.
std::optional<InheritedSocket> inherited_socket();
// Of an open descriptor, with the same exceptions.
InheritedSocket inherited_socket_at(int number);

}  // namespace web
