// SPDX-License-Identifier: Apache-2.0
// The tables of a farm's queue on a PostgreSQL server.
#pragma once

#include <cstdint>

#include "host/queue/postgres_connection.hpp"

namespace queue {

inline constexpr std::int64_t queue_lock = 0x5f0f'ab21'c001;  // of the one that writes

// Makes them where they are missing; of several spoolers that begin together one does. Throws
// std::runtime_error where they are of another version of this program.
void make_postgres_tables(PostgresConnection& connection);

}  // namespace queue
