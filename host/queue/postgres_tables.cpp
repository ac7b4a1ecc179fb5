// SPDX-License-Identifier: Apache-2.0
// As queue.cpp has them for SQLite, with what only a farm needs: files, leases, sessions.
#include "host/queue/postgres_tables.hpp"

#include <stdexcept>
#include <string>

namespace queue {

namespace {

constexpr int schema_version = 1;

// `rowid` is what SQLite has by itself.
constexpr const char* tables = R"(
CREATE TABLE schema_version(version BIGINT NOT NULL);
CREATE TABLE files(
  name TEXT PRIMARY KEY, bytes BIGINT NOT NULL, made TIMESTAMPTZ NOT NULL DEFAULT now());
CREATE TABLE file_parts(
  file TEXT NOT NULL REFERENCES files(name) ON DELETE CASCADE, part BIGINT NOT NULL,
  content BYTEA NOT NULL, PRIMARY KEY(file, part));
ALTER TABLE file_parts ALTER COLUMN content SET STORAGE EXTERNAL;
CREATE TABLE jobs(
  id BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY, name TEXT NOT NULL,
  file TEXT NOT NULL REFERENCES files(name), bytes BIGINT NOT NULL, state TEXT NOT NULL,
  held BIGINT NOT NULL, wanted_printer TEXT NOT NULL, printer TEXT NOT NULL, reason TEXT NOT NULL,
  result TEXT NOT NULL, seconds DOUBLE PRECISION NOT NULL, filament_mm DOUBLE PRECISION NOT NULL,
  commands BIGINT NOT NULL, starts BIGINT NOT NULL, uploaded_ms BIGINT NOT NULL,
  changed_ms BIGINT NOT NULL, place BIGINT NOT NULL);
CREATE UNIQUE INDEX one_active_job ON jobs(printer)
  WHERE state IN ('starting', 'printing', 'paused');
CREATE INDEX jobs_of_file ON jobs(file);
CREATE TABLE changes(
  rowid BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  job BIGINT NOT NULL REFERENCES jobs(id) ON DELETE CASCADE, from_state TEXT NOT NULL,
  to_state TEXT NOT NULL, why TEXT NOT NULL, time_ms BIGINT NOT NULL);
CREATE INDEX changes_of_job ON changes(job);
CREATE TABLE beds(printer TEXT PRIMARY KEY, clear BIGINT NOT NULL, said_ms BIGINT NOT NULL);
CREATE TABLE filaments(printer TEXT PRIMARY KEY, left_mm DOUBLE PRECISION NOT NULL);
CREATE TABLE made_files(
  job BIGINT NOT NULL REFERENCES jobs(id) ON DELETE CASCADE,
  file TEXT NOT NULL REFERENCES files(name), PRIMARY KEY(job, file));
CREATE TABLE spoolers(
  id TEXT PRIMARY KEY, boot TEXT NOT NULL, place TEXT NOT NULL, ends_ms BIGINT NOT NULL);
CREATE TABLE leases(
  printer TEXT PRIMARY KEY, spooler TEXT NOT NULL REFERENCES spoolers(id), boot TEXT NOT NULL,
  token BIGINT NOT NULL, ends_ms BIGINT NOT NULL);
CREATE TABLE checks(
  job BIGINT PRIMARY KEY REFERENCES jobs(id) ON DELETE CASCADE,
  spooler TEXT NOT NULL REFERENCES spoolers(id));
CREATE TABLE sessions(
  id TEXT PRIMARY KEY, mark TEXT NOT NULL, at TIMESTAMPTZ NOT NULL DEFAULT now());
)";

std::int64_t number(PostgresConnection& connection, const std::string& sql) {
  return connection.call([&](auto& work) { return work.exec(sql); })[0][0]
      .template as<std::int64_t>();
}

}  // namespace

void make_postgres_tables(PostgresConnection& connection) {
  connection.execute("BEGIN; SELECT pg_advisory_xact_lock(" + std::to_string(queue_lock) + ")");
  const bool is_new =
      number(connection, "SELECT (to_regclass('schema_version') IS NULL)::int") != 0;
  if (is_new) {
    connection.execute(tables);
    connection.execute("INSERT INTO schema_version VALUES(" + std::to_string(schema_version) + ")");
  }
  const std::int64_t found = number(connection, "SELECT version FROM schema_version");
  if (found != schema_version) {
    connection.execute("ROLLBACK");
    throw std::runtime_error("the queue in the PostgreSQL database is of version " +
                             std::to_string(found) + ", and this program has " +
                             std::to_string(schema_version));
  }
  connection.execute("DELETE FROM sessions WHERE at < now() - interval '7 days'");
  connection.execute("COMMIT");
}

}  // namespace queue
