// SPDX-License-Identifier: Apache-2.0
// A client in the same process as the server, on a connection of its own for each upload.
#include "tools/benchmark/upload_speed.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "host/queue/store.hpp"
#include "host/spooler/spooler.hpp"
#include "host/web/server.hpp"

namespace benchmarks {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t piece_bytes = 1024 * 1024;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

class Descriptor {
 public:
  Descriptor(int number, const char* what) : number_(number) {
    if (number < 0) fail(what);
  }
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

// `put` is write() or send() with its other arguments.
void put_all(std::string_view bytes, const auto& put) {
  while (!bytes.empty()) {
    const ssize_t count = put(bytes.substr(0, piece_bytes));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail("cannot send or write");
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

// Lines as of a slicer.
std::string gcode_of(std::size_t bytes) {
  std::string text;
  text.reserve(bytes + 64);
  for (unsigned i = 0; text.size() < bytes; ++i) {
    text += fmt::format("G1 X{}.{} Y{}.{} E{}.{:05}\n", i * 7 % 180, i % 1000, i * 11 % 180,
                        i * 3 % 1000, i / 900, i * 17 % 100'000);
  }
  text.resize(bytes);
  return text;
}

double write_to_disk(const fs::path& folder, std::string_view text) {
  const auto begin = Clock::now();
  const fs::path part = folder / "alone.part", whole = folder / "alone";
  {
    const Descriptor file(
        open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, S_IRUSR | S_IWUSR),
        "cannot write the file");
    put_all(text, [&](std::string_view piece) {
      return ::write(file.number(), piece.data(), piece.size());
    });
    if (fsync(file.number()) != 0) fail("cannot synchronise the file");
    fs::rename(part, whole);
  }
  queue::sync_folder(folder);
  const double seconds = seconds_since(begin);
  fs::remove(whole);
  return seconds;
}

// What is answered.
std::string answer_to(std::uint16_t port, std::initializer_list<std::string_view> request) {
  const Descriptor client(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), "no socket");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(client.number(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    fail("no connection");
  }
  for (const std::string_view part : request) {
    put_all(part, [&](std::string_view piece) {
      return send(client.number(), piece.data(), piece.size(), MSG_NOSIGNAL);
    });
  }
  std::string answer;
  std::array<char, 4096> buffer{};
  ssize_t count = 0;
  while ((count = recv(client.number(), buffer.data(), buffer.size(), 0)) > 0) {
    answer.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return answer;
}

double upload_form(std::uint16_t port, std::string_view text) {
  constexpr std::string_view begin_of_form =
      "--x\r\nContent-Disposition: form-data; name=\"print\"\r\n\r\nfalse\r\n"
      "--x\r\nContent-Disposition: form-data; name=\"path\"\r\n\r\n\r\n"
      "--x\r\nContent-Disposition: form-data; name=\"file\"; filename=\"part.gcode\"\r\n"
      "Content-Type: application/octet-stream\r\n\r\n";
  constexpr std::string_view end_of_form = "\r\n--x--\r\n";
  const std::string head = fmt::format(
      "POST /api/files/local HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; "
      "boundary=x\r\nContent-Length: {}\r\n\r\n",
      begin_of_form.size() + text.size() + end_of_form.size());
  const auto begin = Clock::now();
  const std::string answer = answer_to(port, {head, begin_of_form, text, end_of_form});
  const double seconds = seconds_since(begin);
  if (!answer.starts_with("HTTP/1.1 201 ")) throw std::runtime_error("refused: " + answer);
  return seconds;
}

void remove_all_jobs(spooler::Spooler& spooler) {
  for (const queue::Job& job : spooler.jobs()) {
    spooler.cancel(job.id);
    spooler.remove(job.id);
  }
}

class Folder {
 public:
  explicit Folder(fs::path path) : path_(std::move(path)) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

 private:
  fs::path path_;
};

double middle(std::vector<double> values) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, place);
  return *place;
}

}  // namespace

double UploadFigures::speed(double UploadRun::* kind) const {
  std::vector<double> seconds;
  for (const UploadRun& run : runs) seconds.push_back(run.*kind);
  return static_cast<double>(bytes) / 1e6 / middle(seconds);
}

double UploadFigures::ratio(double UploadRun::* kind) const {
  std::vector<double> ratios;
  for (const UploadRun& run : runs) ratios.push_back(run.disk / run.*kind);
  return middle(ratios);
}

UploadFigures measure_uploads(const UploadScope& scope,
                              const std::function<void(const std::string&)>& say) {
  const Folder folder(scope.folder);
  spooler::Spooler spooler({.data = scope.folder / "data",
                            .printers = {{.name = "none", .port = "/dev/null"}},
                            .feeder_program = {},
                            .tool_program = {}});
  const web::Server server(spooler, {.host = "127.0.0.1", .port = 0}, {});
  const std::string text = gcode_of(scope.bytes);
  UploadFigures figures{.bytes = text.size(), .runs = {}};
  for (int i = 0; i < scope.runs; ++i) {
    scope.look();
    UploadRun run{.disk = write_to_disk(scope.folder, text),
                  .form = upload_form(server.address().port, text)};
    remove_all_jobs(spooler);
    say(fmt::format("upload {} of {}: {:.2f} s, the disk alone {:.2f} s", i + 1, scope.runs,
                    run.form, run.disk));
    figures.runs.push_back(run);
  }
  return figures;
}

std::string to_json(const UploadFigures& figures) {
  nlohmann::ordered_json json{{"benchmark", "upload"},
                              {"bytes", figures.bytes},
                              {"form_mb_per_second", figures.speed(&UploadRun::form)},
                              {"disk_mb_per_second", figures.speed(&UploadRun::disk)},
                              {"form_of_disk", figures.ratio(&UploadRun::form)}};
  for (const UploadRun& run : figures.runs) {
    json["runs"].push_back({{"form_seconds", run.form}, {"disk_seconds", run.disk}});
  }
  return json.dump(2) + "\n";
}

std::string to_table(const UploadFigures& figures) {
  return fmt::format(
      "{:.0f} MB over loopback, the middle of {} runs\n"
      "  form as of a slicer, to its 201   {:>6.0f} MB/s, {:.2f} of the disk's\n"
      "  disk: written and synchronised    {:>6.0f} MB/s\n",
      static_cast<double>(figures.bytes) / 1e6, figures.runs.size(),
      figures.speed(&UploadRun::form), figures.ratio(&UploadRun::form),
      figures.speed(&UploadRun::disk));
}

}  // namespace benchmarks
