// SPDX-License-Identifier: Apache-2.0
// Server-sent events: the whole state at each change, and a sign of life in between.
#include <chrono>
#include <memory>
#include <thread>

#include "host/web/routes.hpp"

namespace web {

namespace {

using namespace std::chrono_literals;
constexpr int most_streams = 16;
constexpr auto shortest_interval = 200ms;
constexpr auto alive_interval = 2s;

// Counts itself as long as it exists.
class Stream {
 public:
  explicit Stream(Streams streams) : streams_(streams) {
    is_one_too_many = ++streams_.streams > most_streams;
  }
  ~Stream() { --streams_.streams; }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  bool is_one_too_many;
  std::int64_t version = 0;
  std::chrono::steady_clock::time_point sent{};

 private:
  Streams streams_;
};

// Nothing where the queue cannot be read: the stream ends, and its client comes again. An exception
// would end the server.
std::shared_ptr<const spooler::Spooler::Snapshot> next_of(spooler::Spooler& spooler,
                                                          std::int64_t version) {
  try {
    return spooler.next_snapshot(version, alive_interval);
  } catch (const std::exception&) {
    return nullptr;
  }
}

}  // namespace

void add_event_route(Listener& server, spooler::Spooler& spooler, Streams streams) {
  server.Get(
      "/api/v1/events", [&spooler, streams](const httplib::Request&, httplib::Response& response) {
        const auto stream = std::make_shared<Stream>(streams);
        if (stream->is_one_too_many) return answer_error(response, 503, "too many pages are open");
        response.set_chunked_content_provider(
            "text/event-stream", [&spooler, streams, stream](std::size_t, httplib::DataSink& sink) {
              const auto snapshot = next_of(spooler, stream->version);
              if (streams.ends || !snapshot) return false;
              std::string text = "event: alive\ndata: {}\n\n";
              if (snapshot->version != stream->version) {
                text = "id: " + std::to_string(snapshot->version) +
                       "\nevent: state\ndata: " + snapshot->text + "\n\n";
              }
              stream->version = snapshot->version;
              if (!sink.write(text.data(), text.size())) return false;
              std::this_thread::sleep_for(shortest_interval);
              return true;
            });
      });
}

}  // namespace web
