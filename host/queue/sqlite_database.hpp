// SPDX-License-Identifier: Apache-2.0
// A database in one file, with nothing to set up.
#pragma once

#include <filesystem>
#include <memory>

#include "host/queue/database.hpp"

struct sqlite3;

namespace queue {

class SqliteDatabase : public Database {
 public:
  // Made where it is missing. With its log (WAL) and synchronous=FULL a commit has reached the
  // disk when it returns. Throws std::runtime_error.
  explicit SqliteDatabase(const std::filesystem::path& file);

  void execute(const std::string& sql) override;
  Result run(const std::string& sql, const std::vector<Value>& values) override;

 private:
  void begin() override;
  void commit() override;
  void roll_back() noexcept override;

  struct Closer {
    void operator()(sqlite3* handle) const;
  };
  std::unique_ptr<sqlite3, Closer> handle_;
};

}  // namespace queue
