// SPDX-License-Identifier: Apache-2.0
// `stepfabric plan` and its report.
#include "host/spooler/checker.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "host/queue/store.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace spooler {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;
constexpr std::chrono::seconds processor_limit{900};
// In the report, and in what the program says.
constexpr std::size_t most_refused_lines = 200, most_layers = 5000;
constexpr std::size_t longest_reason = 500;

std::int64_t lines_of(const fs::path& file) {
  std::ifstream stream(file);
  return std::count(std::istreambuf_iterator<char>(stream), {}, '\n');
}

bool sync_file(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool synced = fsync(descriptor) == 0;
  close(descriptor);
  return synced;
}

// A file that is gone at the end of its scope.
struct Temporary {
  explicit Temporary(fs::path file) : path(std::move(file)) {}
  ~Temporary() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  const fs::path path;
};

std::string reason_of(const Json& plan) {
  const Json& refused = plan.at("refused");
  if (refused.empty()) return "ends early: " + plan.at("fault").get<std::string>();
  const Json& first = refused.front();
  std::string reason = "line " + first.at("line").dump() + ": " +
                       first.at("text").get<std::string>() + " (" +
                       first.at("reason").get<std::string>() + ")";
  const std::size_t lines = plan.at("refused_lines");
  if (lines > 1) reason += ", and " + std::to_string(lines - 1) + " more";
  return reason;
}

CheckResult refused(std::string reason, std::string report = {}) {
  if (reason.size() > longest_reason) reason.resize(longest_reason);
  return {.accepted = false, .reason = std::move(reason), .report = std::move(report)};
}

CheckResult not_done(const std::string& why) {
  CheckResult result = refused("the check could not be done: " + why);
  result.must_be_repeated = true;
  return result;
}

// What the program says where it cannot write.
bool says_that_the_disk_is_full(std::string_view said) {
  return std::ranges::any_of(std::array{ENOSPC, EDQUOT}, [said](int error) {
    return said.contains(std::generic_category().message(error));
  });
}

}  // namespace

CheckResult check(const fs::path& program, const fs::path& file, const fs::path& commands_file) {
  const Temporary report(commands_file.string() + ".plan"), fresh(commands_file.string() + ".new");
  const auto ended = process::capture(
      {.arguments = {"nice", "-n", "10", program.string(), "plan", file.string(), "--json",
                     report.path.string(), "--commands", fresh.path.string(), "--most-refused",
                     std::to_string(most_refused_lines), "--most-layers",
                     std::to_string(most_layers), "--path",
                     fs::path(commands_file).replace_extension(path_ending).string(), "--picture",
                     fs::path(commands_file).replace_extension(picture_ending).string()},
       .has_input = false,
       .cpu_limit = processor_limit});
  const Json plan = Json::parse(files::text_of(report.path), nullptr, false);
  if (ended.exit_status > 1 || plan.is_discarded()) {
    std::string said = ended.output;
    while (!said.empty() && said.back() == '\n') said.pop_back();
    const bool was_ended = ended.exit_status == command::interrupted;
    if (was_ended || ended.exit_status <= 1 || says_that_the_disk_is_full(said)) {
      return not_done(said);
    }
    return refused(said.empty() ? "the check ended with status " + std::to_string(ended.exit_status)
                                : said);
  }
  const bool accepted = ended.exit_status == 0;
  const std::string reason = accepted ? "" : reason_of(plan);
  const std::string text = plan.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (!accepted) return refused(reason, text);
  fs::permissions(fresh.path, fs::perms::owner_read | fs::perms::owner_write);
  const std::int64_t commands = lines_of(fresh.path);
  if (!sync_file(fresh.path)) return not_done("the commands cannot be written");
  fs::rename(fresh.path, commands_file);
  queue::sync_folder(commands_file.parent_path());
  return {.accepted = true,
          .reason = {},
          .report = text,
          .seconds = plan.at("seconds"),
          .filament_mm = plan.at("filament_mm"),
          .commands = commands};
}

Checker::~Checker() {
  if (thread_.joinable()) thread_.join();
}

void Checker::begin(std::int64_t job, const fs::path& file, const fs::path& commands_file) {
  job_ = job;
  commands_file_ = commands_file;
  done_ = false;
  thread_ = std::thread([this, file, commands_file] {
    try {
      result_ = check(program_, file, commands_file);
    } catch (const std::system_error& error) {
      result_ = not_done(error.what());
    } catch (const std::exception& error) {  // the same at each attempt
      result_ = refused(std::string("the check failed: ") + error.what());
    }
    try {
      if (result_.accepted && publish_) publish_(job_, commands_file);
    } catch (const std::exception& error) {
      result_ = not_done(error.what());
    }
    done_ = true;
  });
}

std::optional<CheckResult> Checker::take_result() {
  if (!thread_.joinable() || !done_) return std::nullopt;
  thread_.join();
  return std::move(result_);
}

}  // namespace spooler
