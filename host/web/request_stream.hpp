// SPDX-License-Identifier: Apache-2.0
// The connection of one request, as httplib reads and writes it.
#pragma once

#include <array>
#include <string>

#include "host/web/connections.hpp"
#include "host/web/http.hpp"

namespace web {

// A request that does not come in time, or whose head is too long, is answered here: 408, 431. Then
// httplib finds the connection ended, and what it writes is dropped.
class RequestStream final : public httplib::Stream {
 public:
  RequestStream(int socket, Connections& connections);
  RequestStream(const RequestStream&) = delete;
  RequestStream& operator=(const RequestStream&) = delete;

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* bytes, std::size_t size) override;
  ssize_t write(const char* bytes, std::size_t size) override;
  using Stream::write;
  // What is written from then on goes nowhere: another one answers.
  void drop_output() { drops_output_ = true; }
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return awaited_.socket; }

 private:
  Clock::duration time_left() const;
  bool fill();
  void follow_head();
  bool wait_to_write() const;
  void answer_and_end(const char* status, const char* why);

  Connections& connections_;
  mutable Awaited awaited_;  // is_writable() waits too
  Clock::duration waited_{};  // for the client, in all; what this server takes is not its fault
  std::array<char, 128 * 1024> buffer_;  // an upload wakes its client less often than with less
  std::size_t used_ = 0, filled_ = 0;  // of the buffer
  std::size_t total_ = 0, head_bytes_ = 0;  // that have come
  std::array<char, 3> last_{};  // of the head
  bool head_ended_ = false, ended_ = false, drops_output_ = false;
};

}  // namespace web
