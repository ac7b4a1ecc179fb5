// SPDX-License-Identifier: Apache-2.0
// The page loses spooler or printer: what is old is shown as old, and it comes back by itself.
#include <signal.h>

#include "tests/host/browser/page_fixture.hpp"

namespace browser_test {
namespace {

using testing::HasSubstr;
using testing::Not;

// Notes after each change whether the page says that it is old, and the words about the job, which
// are words of before from now on.
constexpr const char* watch = R"(
  const words = document.querySelector('.card .job .what');
  words.textContent = 'words of before';
  window.seen = [];
  const note = () => seen.push([document.body.classList.contains('old'), words.textContent]);
  new MutationObserver(note).observe(
    document.body, {subtree: true, childList: true, attributes: true, characterData: true});)";

TEST_F(PageTest, a_killed_spooler_makes_the_page_old_until_the_next_one_has_sent_the_present) {
  begin_spooler();
  open_page();
  choose_file("part.gcode", squares(4, 8));
  expect_job("part.gcode", "queued");
  clear_bed();
  expect_text(".card .job", "line");
  kill_spooler();
  expect_soon([&] { return browser().text("#connection").contains("No connection since"); },
              "it does not say so");
  EXPECT_EQ(browser().run("return document.body.classList.contains('old');"), true);
  EXPECT_EQ(browser().run("return document.title;"), "not connected – StepFabric printers");
  EXPECT_EQ(browser().run("return getComputedStyle(document.querySelector('main')).filter;"),
            "grayscale(1)");
  EXPECT_THAT(browser().text("#connection"), HasSubstr("what you see is from then"));
  browser().run(watch);
  // A stop that cannot be sent says so, and what to do.
  browser().click(".stop");
  expect_text("#message", "was NOT stopped");
  expect_text("#message", "mains switch");
  browser().click("#dismiss");
  EXPECT_TRUE(browser().has("#message[hidden]"));
  begin_spooler();
  expect_soon([&] { return browser().text("#connection") == "live"; }, "it does not come back");
  expect_text(".card .state", "printing");
  // Never the old words as if they were new.
  const Json seen = browser().run("return seen;");
  bool was_old = false, is_back = false;
  for (const Json& each : seen) {
    (each[0] == true ? was_old : is_back) = true;
    EXPECT_FALSE(each[0] == false && each[1] == "words of before") << seen.dump();
  }
  EXPECT_TRUE(was_old && is_back) << seen.dump();
}

TEST_F(PageTest, a_printer_whose_feeder_hangs_is_shown_as_of_then) {
  begin_spooler();
  open_page();
  expect_text(".card .state", "is the bed clear?");
  signal_feeder(SIGSTOP);
  expect_text(".card .age", "No answer since");
  EXPECT_EQ(browser().run("return getComputedStyle(document.querySelector('.heater')).filter;"),
            "grayscale(1)");
  EXPECT_EQ(
      browser().run("return getComputedStyle(document.querySelector('.value .now')).fontStyle;"),
      "italic");
  EXPECT_EQ(browser().text("#connection"), "live");
  signal_feeder(SIGCONT);
  expect_soon([&] { return browser().text(".card .age").empty(); }, "it stays old");
  EXPECT_EQ(
      browser().run("return getComputedStyle(document.querySelector('.value .now')).fontStyle;"),
      "normal");
}

TEST_F(PageTest, a_printer_that_is_gone_from_the_server_is_gone_from_the_page) {
  begin_spooler();
  open_page();
  browser().run("showPrinters({now_ms: Date.now(), jobs: [], printers: []});");
  EXPECT_FALSE(browser().has(".card"));
  EXPECT_FALSE(browser().has(".stop"));
}

}  // namespace
}  // namespace browser_test
