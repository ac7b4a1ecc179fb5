// SPDX-License-Identifier: Apache-2.0
// Unix domain sockets between a feeder and its spooler: lines of text in both directions.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace feeder {

// The lines of a stream of bytes, as they become whole.
class LineReader {
 public:
  // Longer ones are cut: the rest of them is dropped.
  explicit LineReader(std::size_t longest) : longest_(longest) {}
  std::vector<std::string> take(std::string_view bytes);

 private:
  std::size_t longest_;
  std::string line_;
};

// One connection that never blocks. Move-only.
class Connection {
 public:
  explicit Connection(int descriptor);
  Connection(Connection&& other) noexcept;
  Connection& operator=(Connection&& other) noexcept;
  ~Connection();

  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  // A peer that reads nothing for so long that megabytes wait is cut off.
  void send(std::string_view line);
  // Writes what waits, reads what has come.
  std::vector<std::string> exchange();
  bool has_output() const { return !output_.empty(); }

 private:
  void close();
  void flush();
  int descriptor_;
  std::string output_;
  LineReader reader_;
};

// A socket in a folder, whose path may be longer than the address of a socket.
class Listener {
 public:
  // Takes the place of one that was left behind. Throws std::system_error.
  Listener(const std::filesystem::path& folder, const std::string& name);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  int descriptor() const { return descriptor_; }
  std::vector<Connection> accept();

 private:
  int descriptor_;
};

// Closed where nothing listens there.
Connection connect_to(const std::filesystem::path& folder, const std::string& name);

}  // namespace feeder
