// SPDX-License-Identifier: Apache-2.0
// Starting, waiting, ending.
#include "tests/host/browser/page_fixture.hpp"

#include <signal.h>

#include <chrono>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <thread>

#include "directories.hpp"
#include "host/web/http.hpp"
#include "tools/files/file_text.hpp"

namespace browser_test {

using namespace std::chrono_literals;

namespace {

constexpr auto patience = 60s;  // on a machine under load
const std::string stepfabric = BUILD_DIRECTORY "/bin/stepfabric";
constexpr const char* printer = "simulated";

process::Identity noted(const std::filesystem::path& data, const char* file) {
  process::Identity identity;
  std::ifstream(data / "printers" / printer / file) >> identity.id >> identity.started;
  return identity;
}

}  // namespace

std::string squares(int layers, int squares_of_each) {
  std::string text = "M302 P1 ; cold\nG90\nM83\nG92 E0\n";
  for (int layer = 1; layer <= layers; ++layer) {
    text += "G1 Z" + std::to_string(layer * 0.2) + " F600\n";
    for (int square = 0; square < squares_of_each; ++square) {
      const std::string low = std::to_string(square), high = std::to_string(30 - square);
      text += "G0 X" + low + " Y" + low + " F6000\n";
      for (const std::string& corner : {"X" + high + " Y" + low, "X" + high + " Y" + high,
                                        "X" + low + " Y" + high, "X" + low + " Y" + low}) {
        text += "G1 " + corner + " E0.5 F1800\n";
      }
    }
  }
  return text;
}

std::string script(const std::string& file) {
  return files::text_of(PROJECT_DIRECTORY "/tests/host/browser/" + file);
}

std::string button(const std::string& words) {
  return ".card [aria-label='" + words + ": " + printer + "']";
}

std::string row_button(const std::string& words, const std::string& name) {
  return "li [aria-label^='" + words + ": " + name + "']";
}

Controls& controls() {
  static Controls all;
  return all;
}

void PageTest::SetUpTestSuite() { browser_ = std::make_unique<Browser>(); }
void PageTest::TearDownTestSuite() { browser_.reset(); }

PageTest::PageTest() {
  setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
  browser().set_size(1240, 1000);
}

PageTest::~PageTest() {
  note_controls();
  browser().open("about:blank");
  browser().complaints();
  if (spooler_) kill_spooler();
  for (const char* file : {"feeder.process", "chip.process"}) {
    process::signal(noted(folder_.path() / "data", file), SIGKILL);
  }
}

void PageTest::begin_spooler(const std::vector<std::string>& more) {
  const auto log = folder_.path() / "spool.log";
  std::filesystem::remove(log);
  std::vector<std::string> arguments{stepfabric, "spool", "--data",    folder_.path() / "data",
                                     "--listen", listen_, "--printer", printer};
  arguments.insert(arguments.end(), more.begin(), more.end());
  spooler_.emplace(process::Start{.arguments = arguments, .output = log, .has_input = false});
  std::smatch found;
  std::string said;
  expect_soon(
      [&] {
        said = files::text_of(log);
        return std::regex_search(said, found, std::regex("http://(127.0.0.1:[0-9]+)/"));
      },
      "it does not say where it listens");
  listen_ = found[1];  // the same one after a restart
  address_ = "http://" + listen_;
}

void PageTest::kill_spooler() {
  spooler_->signal(SIGKILL);
  spooler_->wait();
  spooler_.reset();
}

void PageTest::signal_feeder(int signal) {
  process::signal(noted(folder_.path() / "data", "feeder.process"), signal);
}

void PageTest::open_page_only() {
  note_controls();
  browser().open(address_ + "/");
  browser().run(script("record_controls.js"));
}

// Of the page that is left.
void PageTest::note_controls() {
  const Json noted = browser().run(
      "return window.controls ? {seen: [...controls.seen], used: [...controls.used]} : null;");
  if (noted.is_null()) return;
  controls().seen.merge(noted.at("seen").get<std::set<std::string>>());
  controls().used.merge(noted.at("used").get<std::set<std::string>>());
}

void PageTest::open_page() {
  open_page_only();
  expect_text("#connection", "live");
  expect_soon([&] { return browser().has(".card:not(.stale)"); }, "the printer does not answer");
}

std::filesystem::path PageTest::written(const std::string& name, const std::string& text) {
  folder_.write(name, text);
  return folder_.path() / name;
}

void PageTest::choose_file(const std::string& name, const std::string& text) {
  browser().type("#files", written(name, text).string());
  expect_soon([&] { return !job(name).is_null(); }, name + " is not uploaded");
}

void PageTest::clear_bed() {
  browser().click(button("The bed is clear"));
  expect_soon([&] { return !browser().has(button("The bed is clear") + ":not([hidden])"); },
              "the bed is not clear");
}

Json PageTest::state() const {
  httplib::Client client(address_);
  const auto answer = client.Get("/api/v1/state");
  return answer ? Json::parse(answer->body, nullptr, false) : Json();
}

Json PageTest::job(const std::string& name) const {
  const Json now = state();
  for (const Json& each : now.at("jobs")) {
    if (each.at("name") == name) return each;
  }
  return {};
}

std::vector<std::string> PageTest::waiting() const {
  std::vector<std::string> names;
  const Json now = state();
  for (const Json& each : now.at("jobs")) {
    const std::string is = each.at("state");
    if (is == "queued" || is == "uploaded" || is == "checking") names.push_back(each.at("name"));
  }
  return names;
}

void PageTest::expect_soon(const std::function<bool()>& fits, const std::string& what) const {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!fits()) {
    if (std::chrono::steady_clock::now() > end) {
      throw std::runtime_error(what + "\n" + state().dump() + "\n" + browser().text("body"));
    }
    std::this_thread::sleep_for(30ms);
  }
}

void PageTest::expect_text(const std::string& selector, const std::string& part) const {
  expect_soon([&] { return browser().has(selector) && browser().text(selector).contains(part); },
              selector + " does not say: " + part);
}

void PageTest::expect_job(const std::string& name, const std::string& wanted) const {
  const auto fits = [&] {
    const Json found = job(name);
    return !found.is_null() && found.at("state") == wanted;
  };
  expect_soon(fits, name + " is not " + wanted);
}

void PageTest::expect_queue(const std::vector<std::string>& names) const {
  const Json wanted = names;
  expect_soon([&] { return waiting() == names; }, "another order than " + wanted.dump());
  expect_soon(
      [&] {
        return browser().run(
                   "return [...document.querySelectorAll('#queue li.waits .name')]"
                   ".map(each => each.textContent);") == wanted;
      },
      "another order on the page than " + wanted.dump());
}

void PageTest::expect_no_complaint() const {
  EXPECT_THAT(browser().complaints(), testing::IsEmpty());
}

}  // namespace browser_test
