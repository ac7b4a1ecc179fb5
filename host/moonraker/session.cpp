// SPDX-License-Identifier: Apache-2.0
// Reading goes on while requests are worked on: an emergency stop waits for none of them.
#include "host/moonraker/session.hpp"

#include <boost/asio/dispatch.hpp>
#include <boost/asio/post.hpp>
#include <utility>

#include "host/moonraker/rpc.hpp"

namespace moonraker {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
namespace http = beast::http;

namespace {

Json id_in(const Json& message) {
  const Json none;
  if (!message.is_object() || !message.contains("id")) return none;
  const Json& id = message.at("id");
  return id.is_string() || id.is_number() ? id : none;
}

bool is_urgent(const Json& message) {
  return message.is_object() && message.contains("method") &&
         message.at("method") == "printer.emergency_stop";
}

}  // namespace

Session::Session(asio::ip::tcp::socket socket, const SessionContext& context, std::string client,
                 bool authorised)
    : Connection(context.core.hub.next_number(), std::move(client), authorised),
      context_(context),
      stream_(std::move(socket)),
      in_order_(asio::make_strand(context.workers.get_executor())),
      stranger_timer_(stream_.get_executor()) {}

void Session::begin(const Handshake& handshake) {
  const auto request = std::make_shared<http::request<http::empty_body>>(
      http::verb::get, handshake.target, handshake.is_http_1_1 ? 11u : 10u);
  request->set(http::field::host, handshake.host);
  request->set(http::field::upgrade, "websocket");
  request->set(http::field::connection, handshake.connection);
  const auto set_what_came = [&](http::field field, const std::string& value) {
    if (!value.empty()) request->set(field, value);
  };
  set_what_came(http::field::sec_websocket_key, handshake.key);
  set_what_came(http::field::sec_websocket_version, handshake.version);
  stream_.set_option(websocket::stream_base::timeout{.handshake_timeout = std::chrono::seconds(10),
                                                     .idle_timeout = context_.limits.idle,
                                                     .keep_alive_pings = true});
  stream_.async_accept(*request, [self = shared_from_this(), request](Error error) {
    if (error) return self->end();
    self->is_open_ = true;
    self->read_next();
    self->write_next();
  });
  stranger_timer_.expires_after(context_.limits.stranger_life);
  stranger_timer_.async_wait([weak = weak_from_this()](Error error) {
    const auto self = weak.lock();
    if (!error && self && !self->is_authorised()) self->drop();
  });
}

void Session::refuse() {
  constexpr std::string_view answer =
      "HTTP/1.1 503 Service Unavailable\r\nConnection: close\r\nContent-Length: 0\r\n\r\n";
  auto& socket = beast::get_lowest_layer(stream_).socket();
  Error error;
  socket.non_blocking(true, error);
  socket.write_some(asio::buffer(answer), error);
  socket.close(error);
}

void Session::read_next() {
  const SocketLimits& limits = context_.limits;
  stream_.read_message_max(is_authorised() ? limits.message : limits.stranger_message);
  stream_.async_read(input_, [self = shared_from_this()](Error error, std::size_t) {
    if (error || self->ended_) return self->end();
    if (!self->stream_.got_text()) {  // JSON is text
      self->stream_.async_close(websocket::close_code::unknown_data,
                                [self](Error) { self->end(); });
      return;
    }
    const std::string text = beast::buffers_to_string(self->input_.data());
    self->input_.consume(self->input_.size());
    if (self->handle(text)) self->read_next();
  });
}

// False where nothing is read until the request is done, or any more.
bool Session::handle(const std::string& text) {
  const bool is_stranger = !is_authorised();
  if (is_stranger && !context_.core.guard.may_ask(client())) {
    drop();
    return false;
  }
  std::optional<Json> message = parsed(text);
  if (!message) {
    put_error(nullptr, parse_error, "Parse error");
    return true;
  }
  if (!is_stranger && is_urgent(*message)) {
    stop(*std::move(message));
    return true;
  }
  const SocketLimits& limits = context_.limits;
  if (in_flight_ >= limits.in_flight || bytes_in_flight_ + text.size() > limits.bytes_in_flight) {
    put_error(*message, too_busy, "too many requests at once");
    return true;
  }
  work_on(*std::move(message), text.size());
  return !is_stranger;
}

void Session::work_on(Json message, std::size_t bytes) {
  ++in_flight_;
  bytes_in_flight_ += bytes;
  const bool is_stranger = !is_authorised();  // nothing else is read meanwhile
  asio::post(
      in_order_, [self = shared_from_this(), message = std::move(message), bytes, is_stranger] {
        const SessionContext& context = self->context_;
        if (context.ends) return;
        if (const auto answer = context.methods.answer_to(context.core, message, self.get())) {
          self->send(std::make_shared<const std::string>(dumped(*answer)));
        }
        self->begin_updates();
        asio::post(self->stream_.get_executor(), [self, bytes, is_stranger] {
          --self->in_flight_;
          self->bytes_in_flight_ -= bytes;
          if (is_stranger && !self->ended_) self->read_next();
        });
      });
}

// It waits for no other request. Of many, some are on their way already.
void Session::stop(Json message) {
  if (stops_in_flight_ >= context_.limits.stops_in_flight ||
      !context_.core.guard.may_stop(client())) {
    return put_error(message, too_busy, "too many emergency stops at once");
  }
  ++stops_in_flight_;
  asio::post(context_.urgent, [self = shared_from_this(), message = std::move(message)] {
    const SessionContext& context = self->context_;
    if (context.ends) return;
    if (const auto answer = context.methods.answer_to(context.core, message, self.get())) {
      self->send(std::make_shared<const std::string>(dumped(*answer)));
    }
    asio::post(self->stream_.get_executor(), [self] { --self->stops_in_flight_; });
  });
}

void Session::put_error(const Json& message, int code, const char* why) {
  put(std::make_shared<const std::string>(dumped(error_answer(id_in(message), {code, why}))));
}

void Session::push_out() {
  asio::post(stream_.get_executor(), [self = shared_from_this()] { self->drop(); });
}

void Session::send(Text text) {
  asio::post(stream_.get_executor(), [self = shared_from_this(), text = std::move(text)]() mutable {
    self->put(std::move(text));
  });
}

void Session::put(Text text) {
  if (ended_) return;
  output_bytes_ += text->size();
  output_.push_back(std::move(text));
  if (output_bytes_ > context_.limits.output) return drop();
  if (output_.size() == 1) write_next();
}

void Session::write_next() {
  if (!is_open_ || ended_ || output_.empty()) return;
  stream_.text(true);
  stream_.async_write(asio::buffer(*output_.front()),
                      [self = shared_from_this()](Error error, std::size_t) {
                        if (error || self->ended_) return self->end();
                        self->output_bytes_ -= self->output_.front()->size();
                        self->output_.pop_front();
                        self->write_next();
                      });
}

void Session::drop() {
  beast::get_lowest_layer(stream_).close();
  end();
}

// What is being written stays until its handler has come.
void Session::end() {
  if (std::exchange(ended_, true)) return;
  stranger_timer_.cancel();
  context_.core.hub.leave(id());
}

}  // namespace moonraker
