// SPDX-License-Identifier: Apache-2.0
// One WebSocket: reads requests, has them worked on, writes what is sent.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "host/moonraker/sockets.hpp"

namespace moonraker {

// What sessions share.
struct SessionContext {
  Core& core;
  const Methods& methods;
  const SocketLimits& limits;
  const std::atomic<bool>& ends;  // what is not begun is left
  boost::asio::thread_pool& workers;
  boost::asio::thread_pool& urgent;  // for the emergency stop alone
};

// All but send() happens in the thread of its io_context. It lives as long as something is awaited.
class Session final : public Connection, public std::enable_shared_from_this<Session> {
 public:
  Session(boost::asio::ip::tcp::socket socket, const SessionContext& context, std::string client,
          bool authorised);

  void begin(const Handshake& handshake);
  // There are too many: answered so, and closed. Instead of begin(), from any thread.
  void refuse();
  void send(Text text) override;
  void push_out() override;
  // Closed without a farewell: its client does not listen.
  void drop();

 private:
  using Error = boost::beast::error_code;
  void read_next();
  bool handle(const std::string& text);
  void work_on(Json message, std::size_t bytes);
  void stop(Json message);
  void put_error(const Json& message, int code, const char* why);
  void put(Text text);
  void write_next();
  void end();

  SessionContext context_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  boost::asio::strand<boost::asio::thread_pool::executor_type> in_order_;
  boost::asio::steady_timer stranger_timer_;
  boost::beast::flat_buffer input_;
  std::deque<Text> output_;
  std::size_t output_bytes_ = 0;
  int in_flight_ = 0, stops_in_flight_ = 0;
  std::size_t bytes_in_flight_ = 0;
  bool is_open_ = false, ended_ = false;
};

}  // namespace moonraker
