// SPDX-License-Identifier: Apache-2.0
// The commands for files: M23 M24 M28 M29 M32. There is no card.
#pragma once

#include "application/active_command.hpp"

namespace application {

class FileCommands {
 public:
  Progress select(ActiveCommand& command);
  Progress resume(ActiveCommand& command);
  Progress begin_storing(ActiveCommand& command);
  Progress end_storing(ActiveCommand& command);

  // Between M28 and M29: lines that a host sends to be stored are not executed.
  bool storing() const { return storing_; }
  static Progress refuse_to_store(ActiveCommand& command);

 private:
  bool storing_{};
  bool file_refused_{};  // of M23, which M24 would print
};

}  // namespace application
