// SPDX-License-Identifier: Apache-2.0
// Two spoolers as users start them, each with its printer, on one database.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <thread>

#include "directories.hpp"
#include "tests/farm/postgres_server.hpp"
#include "tests/host/pty_printer.hpp"
#include "tools/files/file_text.hpp"

namespace {

namespace fs = std::filesystem;
using json = nlohmann::json;
using testing::HasSubstr;
using namespace std::chrono_literals;

constexpr auto patience = 60s;  // on a machine under load

template <class Condition>
bool is_soon(const Condition& fits) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!fits()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(20ms);
  }
  return true;
}

struct Answer {
  std::string status, body;
};

Answer curl(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(),
                   {"curl", "--silent", "--max-time", "60", "--write-out", "\n%{http_code}"});
  const std::string text = process::capture({.arguments = arguments, .has_input = false}).output;
  const std::size_t line = text.rfind('\n');
  return {.status = text.substr(line + 1), .body = text.substr(0, line)};
}

// A spooler's process with one printer, which is named as its folder is.
class Spool {
 public:
  Spool(const fs::path& folder, const std::string& database)
      : folder_(folder), name_(folder.filename()), database_(database) {
    fs::create_directories(folder);
    printer.emplace(folder / "port");
    begin({name_});
  }
  ~Spool() {
    process_.reset();
    process::Identity feeder;
    std::ifstream(folder_ / "data/printers" / name_ / "feeder.process") >> feeder.id >>
        feeder.started;
    process::signal(feeder, SIGKILL);
  }
  void begin(const std::vector<std::string>& printers) {
    const fs::path log = folder_ / "log";
    fs::remove(log);
    std::vector<std::string> call{BUILD_DIRECTORY "/bin/stepfabric",
                                  "spool",
                                  "--no-build",
                                  "--data",
                                  folder_ / "data",
                                  "--listen",
                                  "127.0.0.1:0",
                                  "--database",
                                  database_};
    for (const std::string& each : printers) {
      call.insert(call.end(), {"--printer", each + "=" + port_of(each)});
    }
    process_.emplace(process::Start{.arguments = call, .output = log, .has_input = false});
    std::smatch found;
    std::string said;
    EXPECT_TRUE(is_soon([&] {
      said = files::text_of(log);
      return std::regex_search(said, found, std::regex("(http://[0-9.:]+)/"));
    })) << said;
    address = found[1];
  }
  // Its own printer, or none.
  std::string port_of(const std::string& name) const {
    return (folder_ / (name == name_ ? "port" : "nothing")).string();
  }
  void kill() {
    process_->signal(SIGKILL);
    process_->wait();
  }

  Answer get(const std::string& path) const { return curl({address + path}); }
  Answer post(const std::string& path, const std::string& body = "{}") const {
    return curl({"--data", body, address + path});
  }
  Answer upload(const std::string& text, const std::string& query = "") const {
    std::ofstream(folder_ / "part.gcode") << text;
    return curl({"--form", "print=true", "--form", "file=@" + (folder_ / "part.gcode").string(),
                 address + "/api/v1/jobs" + query});
  }
  json state() const { return json::parse(get("/api/v1/state").body); }
  json job(const json& id) const {
    const json all = state();
    for (const json& each : all.at("jobs")) {
      if (each.at("id") == id) return each;
    }
    return {};
  }
  bool becomes(const json& id, const std::string& wanted) const {
    return is_soon([&] { return job(id).value("state", "") == wanted; });
  }
  void clear_bed() const {
    Answer answer;
    EXPECT_TRUE(is_soon([&] {  // once it has its lease
      answer = post("/api/v1/printers/" + name_ + "/bed_clear", R"({"clear":true})");
      return answer.status == "200";
    })) << answer.body;
  }

  std::optional<host_test::PtyPrinter> printer;
  std::string address;

 private:
  fs::path folder_;
  std::string name_, database_;
  std::optional<process::Process> process_;
};

std::string moves(int count, std::vector<std::string>& lines) {
  lines = {"G28 X Y"};
  for (int i = 1; i < count; ++i) lines.push_back("G1 X" + std::to_string(i % 50) + " F6000");
  std::string text;
  for (const std::string& line : lines) text += line + " ; a comment\n";
  return text;
}

class SpoolFarm : public testing::Test {
 protected:
  SpoolFarm() { setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1); }

  farm_test::PostgresServer server;
  TemporaryFolder folder;
  std::string database = server.new_database();
  Spool left{folder.path() / "left", database}, right{folder.path() / "right", database};
};

TEST_F(SpoolFarm, prints_at_one_what_was_uploaded_at_the_other) {
  std::vector<std::string> lines;
  const Answer answer = left.upload(moves(120, lines));
  ASSERT_EQ(answer.status, "201") << answer.body;
  const json id = json::parse(answer.body).at("id");
  ASSERT_TRUE(right.becomes(id, "queued"));
  right.clear_bed();
  ASSERT_TRUE(left.becomes(id, "finished")) << left.state() << right.state();
  EXPECT_EQ(right.printer->executed(), lines);
  EXPECT_EQ(left.job(id).at("printer"), "right");
  EXPECT_EQ(left.job(id).at("starts"), 1);
  // One for the other's printer waits for it, also where this one is free.
  const Answer named = left.upload("G28 Y\n", "?printer=right");
  ASSERT_EQ(named.status, "201") << named.body;
  const json second = json::parse(named.body).at("id");
  ASSERT_TRUE(left.becomes(second, "queued"));
  left.clear_bed();
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(left.job(second).at("state"), "queued");
  right.clear_bed();
  EXPECT_TRUE(left.becomes(second, "finished"));
  EXPECT_EQ(left.printer->executed().size(), 0u);
}

TEST_F(SpoolFarm, shows_the_others_printers_and_refuses_to_work_them) {
  ASSERT_TRUE(is_soon([&] { return !left.state().at("other_printers").empty(); }));
  const json other = left.state().at("other_printers").at(0);
  EXPECT_EQ(other.at("name"), "right");
  EXPECT_EQ(other.at("lease"), "held");
  EXPECT_NE(other.at("place"), "");
  for (const char* wish : {"bed_clear", "pause", "stop"}) {
    const Answer answer =
        left.post(std::string("/api/v1/printers/right/") + wish, R"({"clear":true})");
    EXPECT_EQ(answer.status, "409") << wish;
    EXPECT_THAT(answer.body, HasSubstr(other.at("place").get<std::string>()));
  }
  EXPECT_EQ(left.upload("G28\n", "?printer=nowhere").status, "404");
  // A second one that offers the same name.
  left.kill();
  left.begin({"left", "right"});
  const auto refusal = [&] {
    const json all = left.state();
    for (const json& printer : all.at("printers")) {
      if (printer.at("name") == "right") return printer.at("fault").get<std::string>();
    }
    return std::string();
  };
  EXPECT_TRUE(is_soon([&] { return refusal().contains("belongs to the spooler on"); }))
      << left.state();
}

TEST_F(SpoolFarm, goes_on_printing_without_its_server_and_makes_up_for_it_afterwards) {
  std::vector<std::string> lines;
  const json id = json::parse(left.upload(moves(1500, lines)).body).at("id");
  ASSERT_TRUE(left.becomes(id, "queued"));
  left.clear_bed();
  ASSERT_TRUE(is_soon([&] { return left.printer->executed().size() > 50; }));
  ASSERT_TRUE(left.becomes(id, "printing"));
  server.stop(SIGQUIT);
  const Answer refused = left.upload("G28\n");
  EXPECT_EQ(refused.status, "503");
  EXPECT_THAT(refused.body, HasSubstr("database"));
  EXPECT_TRUE(is_soon([&] { return left.state().at("queue_is_old").get<bool>(); }));
  EXPECT_TRUE(is_soon([&] {
    return left.state().at("fault").get<std::string>().contains("database");
  })) << left.state();
  EXPECT_EQ(left.job(id).at("state"), "printing") << "as it was seen last";
  EXPECT_EQ(left.get("/api/v1/jobs/1").status, "503");
  const std::size_t before = left.printer->executed().size();
  ASSERT_LT(before, lines.size()) << "printed before the server was stopped";
  EXPECT_TRUE(is_soon([&] { return left.printer->executed().size() == lines.size(); }));
  server.start();
  ASSERT_TRUE(left.becomes(id, "finished")) << left.state();
  EXPECT_EQ(left.printer->executed(), lines);
  EXPECT_FALSE(left.state().at("queue_is_old"));
  EXPECT_EQ(left.job(id).at("starts"), 1);
  EXPECT_TRUE(is_soon([&] { return left.upload("G28\n").status == "201"; }));
}

// Its own process gets the printer back at once, with the print.
TEST_F(SpoolFarm, follows_its_print_again_after_it_was_killed) {
  std::vector<std::string> lines;
  const json id = json::parse(right.upload(moves(1500, lines)).body).at("id");
  ASSERT_TRUE(left.becomes(id, "queued"));
  left.clear_bed();
  ASSERT_TRUE(is_soon([&] { return left.printer->executed().size() > 50; }));
  left.kill();
  left.begin({"left"});
  ASSERT_TRUE(right.becomes(id, "finished")) << right.state();
  EXPECT_EQ(left.printer->executed(), lines);
  EXPECT_EQ(right.job(id).at("starts"), 1);
}

}  // namespace
