// SPDX-License-Identifier: Apache-2.0
// Linux's calls for sockets. Paths go through /proc/self/fd: an address has room for 107 bytes.
#include "host/feeder/local_socket.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace feeder {

namespace {

constexpr std::size_t longest_line = 64 * 1024;
constexpr std::size_t most_output = 4 * 1024 * 1024;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// A socket's address in an open folder, valid as long as that.
class Address {
 public:
  Address(const std::filesystem::path& folder, const std::string& name)
      : folder_(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
    if (folder_ < 0) fail("cannot open " + folder.string());
    const std::string path = "/proc/self/fd/" + std::to_string(folder_) + "/" + name;
    address_.sun_family = AF_UNIX;
    std::strncpy(address_.sun_path, path.c_str(), sizeof address_.sun_path - 1);
  }
  ~Address() { ::close(folder_); }
  Address(const Address&) = delete;
  Address& operator=(const Address&) = delete;
  const sockaddr* pointer() const { return reinterpret_cast<const sockaddr*>(&address_); }
  static constexpr socklen_t size = sizeof(sockaddr_un);

 private:
  int folder_;
  sockaddr_un address_{};
};

int new_socket() {
  const int descriptor = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (descriptor < 0) fail("cannot make a socket");
  return descriptor;
}

}  // namespace

std::vector<std::string> LineReader::take(std::string_view bytes) {
  std::vector<std::string> lines;
  for (const char c : bytes) {
    if (c == '\n') {
      lines.push_back(std::exchange(line_, {}));
    } else if (line_.size() < longest_) {
      line_ += c;
    }
  }
  return lines;
}

Connection::Connection(int descriptor) : descriptor_(descriptor), reader_(longest_line) {}

Connection::Connection(Connection&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      output_(std::move(other.output_)),
      reader_(std::move(other.reader_)) {}

Connection& Connection::operator=(Connection&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(output_, other.output_);
  std::swap(reader_, other.reader_);
  return *this;
}

Connection::~Connection() { close(); }

void Connection::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

void Connection::send(std::string_view line) {
  if (!is_open()) return;
  output_ += line;
  output_ += '\n';
  if (output_.size() > most_output) return close();
  flush();
}

void Connection::flush() {
  while (is_open() && !output_.empty()) {
    const ssize_t count = ::send(descriptor_, output_.data(), output_.size(), MSG_NOSIGNAL);
    if (count < 0) {
      if (errno != EAGAIN && errno != EINTR) close();
      return;
    }
    output_.erase(0, static_cast<std::size_t>(count));
  }
}

std::vector<std::string> Connection::exchange() {
  flush();
  std::vector<std::string> lines;
  std::array<char, 4096> buffer{};
  while (is_open()) {
    const ssize_t count = recv(descriptor_, buffer.data(), buffer.size(), 0);
    if (count > 0) {
      for (std::string& line : reader_.take({buffer.data(), static_cast<std::size_t>(count)})) {
        lines.push_back(std::move(line));
      }
    } else if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
      break;
    } else {
      close();
    }
  }
  return lines;
}

Listener::Listener(const std::filesystem::path& folder, const std::string& name)
    : descriptor_(new_socket()) {
  std::filesystem::remove(folder / name);
  const Address address(folder, name);
  if (bind(descriptor_, address.pointer(), Address::size) != 0 || listen(descriptor_, 8) != 0) {
    const int error = errno;
    ::close(descriptor_);
    errno = error;
    fail("cannot listen in " + folder.string());
  }
}

Listener::~Listener() { ::close(descriptor_); }

std::vector<Connection> Listener::accept() {
  std::vector<Connection> connections;
  while (true) {
    const int descriptor = accept4(descriptor_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (descriptor < 0) return connections;
    connections.emplace_back(descriptor);
  }
}

Connection connect_to(const std::filesystem::path& folder, const std::string& name) {
  if (!std::filesystem::exists(folder)) return Connection(-1);
  const Address address(folder, name);
  const int descriptor = new_socket();
  if (connect(descriptor, address.pointer(), Address::size) == 0) return Connection(descriptor);
  ::close(descriptor);
  return Connection(-1);
}

}  // namespace feeder
