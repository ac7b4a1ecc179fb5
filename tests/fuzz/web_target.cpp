// SPDX-License-Identifier: Apache-2.0
// The whole web server of a spooler, over loopback: each connection gets one whole answer or none,
// and files and jobs agree afterwards. The spooler's loop stands still, its printer has no feeder.
#include <netinet/in.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "host/spooler/spooler.hpp"
#include "host/web/server.hpp"
#include "tests/fuzz/property.hpp"

namespace {

namespace fs = std::filesystem;

fs::path new_folder() {
  const char* memory = "/dev/shm";
  std::string name = ((fs::is_directory(memory) ? fs::path(memory) : fs::temp_directory_path()) /
                      "stepfabric_fuzz_XXXXXX")
                         .string();
  fuzz::require(mkdtemp(name.data()) != nullptr, "no folder {}", name);
  return name;
}

struct Environment {
  const fs::path folder = new_folder();
  spooler::Spooler spool{{.data = folder / "data",
                          .printers = {{.name = "left", .port = "/dev/null"}},
                          .feeder_program = "/bin/false",
                          .tool_program = "/bin/false"}};
  web::Server server{
      spool,
      {.host = "127.0.0.1", .port = 0},
      {.key = {}, .names = {"printer.example"}, .rate = {.burst = 1e18, .per_second = 1e18}}};
  ~Environment() { fs::remove_all(folder); }
};

std::string answer_to(std::string_view request, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  // No address remains in use after a connection: there are as many as ports.
  const linger at_once{.l_onoff = 1, .l_linger = 0};
  setsockopt(connection, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  fuzz::require(connect(connection, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0,
                "the server takes no connection");
  while (!request.empty()) {
    const ssize_t count = send(connection, request.data(), request.size(), MSG_NOSIGNAL);
    if (count <= 0) {
      break;  // it has answered
    }
    request.remove_prefix(static_cast<std::size_t>(count));
  }
  shutdown(connection, SHUT_WR);
  std::string text;
  std::array<char, 64 * 1024> buffer{};
  ssize_t count = 0;
  while ((count = recv(connection, buffer.data(), buffer.size(), 0)) > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
    // A stream of events has no end.
    if (text.contains("text/event-stream") && text.contains("\n\n")) break;
  }
  close(connection);
  return text;
}

void require_an_answer(const std::string& answer) {
  if (answer.empty()) return;
  fuzz::require(
      answer.starts_with("HTTP/1.") && answer.size() > 12 && answer[9] >= '1' && answer[9] <= '5',
      "no answer of HTTP: {}", answer.substr(0, 80));
  const std::size_t end = answer.find("\r\n\r\n");
  if (answer.starts_with("HTTP/1.1 100")) return;
  fuzz::require(end != std::string::npos, "the head of the answer has no end");
  fuzz::require(!answer.starts_with("HTTP/1.1 500"), "the server has failed: {}",
                answer.substr(end));
  const bool is_error = answer[9] == '4' && !answer.starts_with("HTTP/1.1 416");
  const bool is_packed = answer.find("\r\nContent-Encoding: ") < end;
  const bool has_body = end + 4 < answer.size() && !is_packed;
  if (is_error && has_body && answer.contains("application/json")) {
    fuzz::require(!nlohmann::json::parse(answer.substr(end + 4), nullptr, false).is_discarded(),
                  "an error is no JSON: {}", answer.substr(end));
  }
}

// Each job has its file, each file its job, and nothing else was written. Then all are removed.
void require_order(Environment& all) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(all.folder)) {
    fuzz::require(entry.path().filename() == "data", "there is {}", entry.path().string());
  }
  for (const auto& entry : fs::directory_iterator(all.folder / "data" / "files")) {
    (void)entry;
    ++files;
  }
  const auto jobs = all.spool.jobs();
  fuzz::require(files == jobs.size(), "{} files and {} jobs", files, jobs.size());
  for (const queue::Job& job : jobs) {
    const fs::path file = all.spool.store().path_of(job.file);
    fuzz::require(fs::file_size(file) == static_cast<std::uintmax_t>(job.bytes),
                  "{} has another size", file.string());
    fuzz::require(job.name == queue::cleaned_name(job.name), "the name {} is not clean", job.name);
    if (!is_final(job.state)) all.spool.cancel(job.id);
    all.spool.remove(job.id);
  }
}

constexpr std::array<std::string_view, 8> targets{
    "/api/v1/jobs",           "/api/files/local",
    "/api/v1/jobs/1/hold",    "/api/v1/jobs/1/move",
    "/api/printer/command",   "/api/job",
    "/printers/left/api/job", "/api/v1/printers/left/bed_clear"};

// The first byte: 0 the rest are all bytes of a request, 1 a form, 2 a form in chunks, 3 JSON, 4 a
// path's end up to a line end, and a file; the second one: where it is sent.
std::string request_of(std::string_view input) {
  const unsigned kind = static_cast<unsigned char>(input[0]) % 5u;
  if (kind == 0 || input.size() < 2) return std::string(input.substr(1));
  if (kind == 4) {
    input.remove_prefix(1);
    const std::size_t end = std::min(input.find('\n'), input.size());
    const std::string_view file = input.substr(std::min(end + 1, input.size()));
    return "PUT /api/v1/files/local/" + std::string(input.substr(0, end)) +
           " HTTP/1.1\r\nHost: localhost\r\nContent-Length: " + std::to_string(file.size()) +
           "\r\n\r\n" + std::string(file);
  }
  const std::string_view target =
      targets[static_cast<unsigned char>(input[1]) % (kind == 3 ? targets.size() : 2)];
  const std::string body(input.substr(2));
  const std::string type = kind == 3 ? "application/json" : "multipart/form-data; boundary=x";
  return "POST " + std::string(target) + " HTTP/1.1\r\nHost: localhost\r\nContent-Type: " + type +
         "\r\n" +
         (kind == 2 ? "Transfer-Encoding: chunked"
                    : "Content-Length: " + std::to_string(body.size())) +
         "\r\n\r\n" + body;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Environment environment;
  if (size == 0) return 0;
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  require_an_answer(answer_to(request_of(input), environment.server.address().port));
  require_order(environment);
  return 0;
}
