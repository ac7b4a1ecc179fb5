// SPDX-License-Identifier: Apache-2.0
// The database itself refuses two active jobs on one printer.
#include "host/queue/sqlite_tables.hpp"

namespace queue {

namespace {

constexpr std::int64_t schema_version = 2;

constexpr const char* tables = R"(
CREATE TABLE IF NOT EXISTS jobs(
  id INTEGER PRIMARY KEY AUTOINCREMENT, name TEXT NOT NULL, file TEXT NOT NULL,
  bytes INTEGER NOT NULL, state TEXT NOT NULL, held INTEGER NOT NULL, wanted_printer TEXT NOT NULL,
  printer TEXT NOT NULL, reason TEXT NOT NULL, result TEXT NOT NULL, seconds REAL NOT NULL,
  filament_mm REAL NOT NULL, commands INTEGER NOT NULL, starts INTEGER NOT NULL,
  uploaded_ms INTEGER NOT NULL, changed_ms INTEGER NOT NULL, place INTEGER NOT NULL);
CREATE UNIQUE INDEX IF NOT EXISTS one_active_job ON jobs(printer)
  WHERE state IN ('starting', 'printing', 'paused');
CREATE TABLE IF NOT EXISTS changes(
  job INTEGER NOT NULL REFERENCES jobs(id) ON DELETE CASCADE, from_state TEXT NOT NULL,
  to_state TEXT NOT NULL, why TEXT NOT NULL, time_ms INTEGER NOT NULL);
CREATE INDEX IF NOT EXISTS changes_of_job ON changes(job);
CREATE TABLE IF NOT EXISTS beds(printer TEXT PRIMARY KEY, clear INTEGER NOT NULL);
CREATE TABLE IF NOT EXISTS kept_files(file TEXT PRIMARY KEY);
)";

constexpr const char* since_version_2 = R"(
ALTER TABLE beds ADD COLUMN said_ms INTEGER NOT NULL DEFAULT 0;
CREATE TABLE filaments(printer TEXT PRIMARY KEY, left_mm REAL NOT NULL);
)";

}  // namespace

void make_sqlite_tables(Database& database) {
  Statement version(database, "PRAGMA user_version");
  version.step();
  const std::int64_t found = version.integer(0);  // 0: it is new, or from before versions
  if (found > schema_version) {
    throw std::runtime_error("job database: it is of version " + std::to_string(found) +
                             ", and this program has " + std::to_string(schema_version));
  }
  if (found == schema_version) return;
  Transaction transaction(database);
  database.execute(tables);
  database.execute(since_version_2);
  database.execute("PRAGMA user_version = " + std::to_string(schema_version));
  transaction.commit();
}

}  // namespace queue
