// SPDX-License-Identifier: Apache-2.0
// The loop that moves bytes between port, conversation and spooler.
#include "host/feeder/feeder.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

namespace feeder {

namespace {

using Json = nlohmann::json;
constexpr int pass_ms = 50;
constexpr Time open_interval{500};
constexpr Time state_interval{1000};
constexpr Time lonely_limit{60'000};
constexpr std::size_t longest_reply = 512;

Time now() {
  return std::chrono::duration_cast<Time>(std::chrono::steady_clock::now().time_since_epoch());
}

constexpr std::int64_t never_ms = std::numeric_limits<std::int64_t>::max();

// Since the machine's start, also while it slept: as the spooler counts.
std::int64_t boot_ms() {
  timespec time{};
  clock_gettime(CLOCK_BOOTTIME, &time);
  return std::int64_t{time.tv_sec} * 1000 + time.tv_nsec / 1'000'000;
}

int locked(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
  const std::filesystem::path file = folder / "lock";
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) throw std::runtime_error("cannot write " + file.string());
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  close(descriptor);
  throw std::runtime_error("another feeder has " + folder.string());
}

std::int64_t random_base() {
  std::random_device source;
  return std::uniform_int_distribution<std::int64_t>(Conversation::lowest_base,
                                                     Conversation::highest_base)(source);
}

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

constexpr std::string_view name_of(Link link) {
  switch (link) {
    case Link::closed:
      return "closed";
    case Link::asking:
      return "asking";
    case Link::ready:
      return "ready";
  }
  return "";
}

// Bytes beyond ASCII are no text of a printer.
std::string plain(std::string text) {
  for (char& c : text) {
    if ((c < ' ' || c > '~') && c != '\n' && c != '\r') c = '?';
  }
  return text;
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Feeder::Feeder(const Options& options)
    : lock_(locked(options.folder)),
      journal_(options.folder / journal_name),
      conversation_(journal_, random_base, options.pause_limit),
      port_(options.port, options.baud),
      listener_(options.folder, socket_name),
      replies_(longest_reply),
      used_at_(now()) {
  conversation_.on_said = [this](std::string_view line) {
    send_all(dumped(Json{{"event", "said"}, {"line", line}}));
  };
}

Feeder::~Feeder() { close(lock_); }

void Feeder::run(const std::function<bool()>& ended) {
  while (!ended() && !end_wanted_ && !is_of_no_use()) {
    wait();
    serve_port();
    serve_connections();
  }
}

void Feeder::wait() {
  std::vector<pollfd> files{{listener_.descriptor(), POLLIN, 0}};
  if (port_.is_open()) {
    const int events = to_port_.empty() ? POLLIN : POLLIN | POLLOUT;
    files.push_back({port_.descriptor(), static_cast<short>(events), 0});
  }
  for (const Connection& connection : connections_) {
    const int events = connection.has_output() ? POLLIN | POLLOUT : POLLIN;
    files.push_back({connection.descriptor(), static_cast<short>(events), 0});
  }
  poll(files.data(), files.size(), pass_ms);
}

void Feeder::serve_port() {
  const Time time = now();
  if (!port_.is_open() && time - tried_at_ >= open_interval) {
    tried_at_ = time;
    to_port_.clear();
    if (port_.open()) conversation_.opened(time);
  }
  const bool was_open = port_.is_open();
  for (const std::string& line : replies_.take(plain(port_.read()))) {
    conversation_.heard(line, time);
  }
  conversation_.update(time);
  to_port_ += conversation_.take_output();
  to_port_.erase(0, port_.write(to_port_));
  if (was_open && !port_.is_open()) {
    conversation_.closed();
    replies_ = LineReader(longest_reply);
  }
}

void Feeder::serve_connections() {
  for (Connection& connection : listener_.accept()) {
    connection.send(state());
    connections_.push_back(std::move(connection));
  }
  for (Connection& connection : connections_) {
    for (const std::string& line : connection.exchange()) connection.send(obey(line));
  }
  std::erase_if(connections_, [](const Connection& each) { return !each.is_open(); });
  const Time time = now();
  if (!connections_.empty()) used_at_ = time;
  std::string present = state();
  if (present != sent_state_ || time - sent_at_ >= state_interval) {
    sent_state_ = std::move(present);
    sent_at_ = time;
    send_all(sent_state_);
  }
}

// The answer to a line of the spooler.
std::string Feeder::obey(const std::string& line) {
  std::string wish, refusal;
  Json job;
  try {
    const Json json = Json::parse(line);
    wish = json.at("do");
    job = json.value("job", Json());
    if (wish == "start" && boot_ms() > json.value("not_after_ms", never_ms)) {
      refusal = "the start came after the end of the printer's lease";
    } else if (wish == "start") {
      refusal = conversation_.start(job.get<std::int64_t>(), json.at("file"), json.at("commands"));
    } else if (wish == "pause") {
      refusal = conversation_.pause();
    } else if (wish == "resume") {
      refusal = conversation_.resume();
    } else if (wish == "cancel") {
      refusal = conversation_.cancel(job.is_null() ? std::nullopt
                                                   : std::optional(job.get<std::int64_t>()));
    } else if (wish == "stop") {
      conversation_.stop_everything();
    } else if (wish == "send") {
      refusal = conversation_.send(json.at("line").get<std::string>());
    } else if (wish == "forget") {
      refusal = conversation_.forget(job.get<std::int64_t>());
    } else if (wish == "end") {
      end_wanted_ = true;
    } else {
      refusal = "no such wish";
    }
  } catch (const std::exception& error) {
    refusal = error.what();
  }
  return dumped(Json{{"event", "answer"}, {"do", wish}, {"job", job}, {"refused", refusal}});
}

void Feeder::send_all(const std::string& line) {
  for (Connection& connection : connections_) connection.send(line);
}

std::string Feeder::state() const {
  const Temperatures& heat = conversation_.temperatures();
  Json json{
      {"event", "state"},
      {"link", name_of(conversation_.link())},
      {"waits_for_user", conversation_.waits_for_user()},
      {"hotend_to_restore", conversation_.hotend_to_restore()},
      {"resends", conversation_.resends()},
      {"hotend", {number(heat.hotend), number(heat.hotend_target), number(heat.hotend_power)}},
      {"bed", {number(heat.bed), number(heat.bed_target), number(heat.bed_power)}},
      {"homed", conversation_.homed_axes()},
      {"fault", port_.fault().empty() ? conversation_.fault() : port_.fault()},
      {"process", getpid()}};
  if (const auto& position = conversation_.position()) {
    json["position"] = {{"mm", position->mm}, {"steps", position->steps}};
  }
  if (const auto& record = conversation_.record()) {
    json["job"] = record->job;
    json["phase"] = name_of(record->phase);
    json["why"] = record->why;
    json["done"] = conversation_.done();
    json["commands"] = record->commands;
  }
  return dumped(json);
}

bool Feeder::is_of_no_use() const {
  const auto& record = conversation_.record();
  const bool works = record && !is_over(record->phase);
  return !works && connections_.empty() && now() - used_at_ > lonely_limit;
}

}  // namespace feeder
