// SPDX-License-Identifier: Apache-2.0
// The tables of one spooler's queue.
#pragma once

#include "host/queue/database.hpp"

namespace queue {

// Makes them where they are missing. Throws std::runtime_error where they are of a newer version of
// this program.
void make_sqlite_tables(Database& database);

}  // namespace queue
