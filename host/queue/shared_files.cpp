// SPDX-License-Identifier: Apache-2.0
// Pieces as rows of one transaction.
#include "host/queue/shared_files.hpp"

#include <cstddef>
#include <fstream>
#include <span>
#include <stdexcept>

namespace queue {

namespace {

constexpr std::size_t piece_bytes = 256 * 1024;

std::span<const std::byte> bytes_of(const std::vector<char>& piece, std::streamsize size) {
  return std::as_bytes(std::span(piece).first(static_cast<std::size_t>(size)));
}

}  // namespace

// A transaction on this connection, undone unless it was committed.
class SharedFiles::Work {
 public:
  Work(PostgresConnection& connection, const char* begin) : connection_(connection) {
    connection_.connect();
    connection_.execute(begin);
  }
  ~Work() {
    try {
      if (!committed_ && connection_.is_open()) connection_.execute("ROLLBACK");
    } catch (const std::exception&) {  // the server does it
    }
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  pqxx::result run(const char* sql, const pqxx::params& values) {
    return connection_.call([&](auto& work) { return work.exec(sql, values); });
  }
  void commit() {
    connection_.execute("COMMIT");
    committed_ = true;
  }

 private:
  PostgresConnection& connection_;
  bool committed_ = false;
};

void SharedFiles::put(const std::string& name, const std::filesystem::path& file,
                      std::optional<JobId> job) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  Work work(connection_, "BEGIN");
  work.run(
      "INSERT INTO files(name, bytes) VALUES($1, 0) ON CONFLICT(name) DO UPDATE SET made = now()",
      pqxx::params{name});
  work.run("DELETE FROM file_parts WHERE file = $1", pqxx::params{name});
  std::vector<char> piece(piece_bytes);
  std::int64_t bytes = 0;
  for (std::int64_t part = 0; stream; ++part) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const std::streamsize size = stream.gcount();
    if (size == 0) break;
    const auto content = bytes_of(piece, size);
    work.run("INSERT INTO file_parts(file, part, content) VALUES($1, $2, $3)",
             pqxx::params{name, part, pqxx::bytes_view(content.data(), content.size())});
    bytes += size;
  }
  if (stream.bad() || bytes != static_cast<std::int64_t>(std::filesystem::file_size(file))) {
    throw std::runtime_error("cannot read all of " + file.string());
  }
  work.run("UPDATE files SET bytes = $2 WHERE name = $1", pqxx::params{name, bytes});
  if (job) {
    work.run("INSERT INTO made_files(job, file) VALUES($1, $2) ON CONFLICT DO NOTHING",
             pqxx::params{*job, name});
  }
  work.commit();
}

void SharedFiles::fetch(const std::string& name, const Store& store) {
  // One state of the file, although it is written again meanwhile.
  Work work(connection_, "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY");
  const pqxx::result found =
      work.run("SELECT bytes FROM files WHERE name = $1", pqxx::params{name});
  if (found.empty()) throw std::runtime_error("the queue's database has no file " + name);
  const auto bytes = found[0][0].as<std::int64_t>();
  Store::Upload upload(store, name);
  for (std::int64_t part = 0; upload.bytes() < bytes; ++part) {
    const pqxx::result row = work.run(
        "SELECT content FROM file_parts WHERE file = $1 AND part = $2", pqxx::params{name, part});
    if (row.empty()) break;
    const auto content = row[0][0].as<pqxx::bytes>();
    upload.write({reinterpret_cast<const char*>(content.data()), content.size()});
  }
  if (upload.bytes() != bytes) {
    throw std::runtime_error("the queue's database has not all of " + name);
  }
  work.commit();
  upload.keep();
}

std::vector<std::string> SharedFiles::made_for(JobId job) {
  Work work(connection_, "BEGIN READ ONLY");
  std::vector<std::string> names;
  for (const pqxx::row& row :
       work.run("SELECT file FROM made_files WHERE job = $1 ORDER BY file", pqxx::params{job})) {
    names.emplace_back(row[0].view());
  }
  work.commit();
  return names;
}

}  // namespace queue
