// SPDX-License-Identifier: Apache-2.0
// One read is always under way; it is waited for as long as the caller wants.
#include "tests/moonraker/socket_client.hpp"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>

namespace moonraker_test {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

struct SocketClient::Machinery {
  asio::io_context io;
  websocket::stream<tcp::socket> stream{io};
  beast::flat_buffer buffer;
  bool reads = false, is_open = false;
  beast::error_code error;
  int status = 0;
  std::int64_t last_id = 0;
  std::deque<Json> kept;

  void read() {
    reads = true;
    stream.async_read(buffer, [this](beast::error_code fault, std::size_t) {
      reads = false;
      error = fault;
      if (fault) is_open = false;
    });
  }
  // False where nothing has come.
  bool wait(std::chrono::milliseconds time) {
    if (!is_open) return false;
    if (!reads) read();
    const auto end = Clock::now() + time;
    while (reads && Clock::now() < end) {
      io.restart();
      io.run_one_for(end - Clock::now());
    }
    return !reads;
  }
};

SocketClient::SocketClient(int port, const std::map<std::string, std::string>& headers,
                           const std::string& target)
    : machinery_(std::make_unique<Machinery>()) {
  Machinery& own = *machinery_;
  own.stream.next_layer().connect(
      {asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)});
  own.stream.set_option(
      websocket::stream_base::decorator([headers](websocket::request_type& request) {
        for (const auto& [name, value] : headers) request.set(name, value);
      }));
  websocket::response_type response;
  own.stream.handshake(response, "127.0.0.1:" + std::to_string(port), target, own.error);
  own.status = static_cast<int>(response.result_int());
  own.is_open = !own.error;
}

SocketClient::~SocketClient() = default;
SocketClient::SocketClient(SocketClient&&) noexcept = default;

int SocketClient::status() const { return machinery_->status; }

void SocketClient::send(const std::string& text, bool is_text) {
  machinery_->stream.text(is_text);
  beast::error_code error;
  machinery_->stream.write(asio::buffer(text), error);
}

std::optional<Json> SocketClient::receive(std::chrono::milliseconds time) {
  Machinery& own = *machinery_;
  if (!own.wait(time) || own.error) return std::nullopt;
  const std::string text = beast::buffers_to_string(own.buffer.data());
  own.buffer.consume(own.buffer.size());
  return Json::parse(text);
}

Json SocketClient::call(const std::string& method, const Json& params) {
  const std::int64_t id = ++machinery_->last_id;
  send(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}, {"id", id}}.dump());
  while (auto message = receive()) {
    if (message->contains("id") && message->at("id") == id) return *message;
    machinery_->kept.push_back(*std::move(message));
  }
  return {};
}

std::optional<Json> SocketClient::notified(const std::string& method,
                                           std::chrono::milliseconds time) {
  const auto end = Clock::now() + time;
  auto& kept = machinery_->kept;
  while (true) {
    std::optional<Json> message;
    if (!kept.empty()) {
      message = std::move(kept.front());
      kept.pop_front();
    } else {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
      message = receive(std::max(left, std::chrono::milliseconds(0)));
    }
    if (!message) return std::nullopt;
    if (message->value("method", "") == method) return message->value("params", Json::array());
  }
}

std::optional<int> SocketClient::end(std::chrono::milliseconds time) {
  const auto limit = Clock::now() + time;
  while (machinery_->is_open) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(limit - Clock::now());
    if (left.count() <= 0 || !machinery_->wait(left)) return std::nullopt;
    machinery_->buffer.consume(machinery_->buffer.size());
  }
  return machinery_->stream.reason().code;
}

void SocketClient::close() {
  beast::error_code error;
  machinery_->stream.next_layer().close(error);
  machinery_->is_open = false;
}

}  // namespace moonraker_test
