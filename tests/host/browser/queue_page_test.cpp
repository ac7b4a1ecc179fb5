// SPDX-License-Identifier: Apache-2.0
// The queue on the page: order by mouse, finger and keyboard; held and refused files; a key.
#include "tests/host/browser/page_fixture.hpp"

namespace browser_test {
namespace {

using testing::HasSubstr;

std::string handle(const std::string& name) { return "li [aria-label^='Move " + name + "']"; }

TEST_F(PageTest, the_order_is_changed_by_mouse_finger_buttons_and_arrow_keys) {
  begin_spooler();
  open_page();
  for (const char* name : {"a.gcode", "b.gcode", "c.gcode", "d.gcode"}) {
    choose_file(name, squares(1, 1));
  }
  for (const char* name : {"a.gcode", "d.gcode"}) expect_job(name, "queued");
  expect_queue({"a.gcode", "b.gcode", "c.gcode", "d.gcode"});
  browser().drag(handle("a.gcode"), handle("c.gcode"), 15, "mouse");
  expect_soon(
      [&] {
        return waiting() == std::vector<std::string>{"b.gcode", "c.gcode", "a.gcode", "d.gcode"};
      },
      "mouse");
  expect_queue({"b.gcode", "c.gcode", "a.gcode", "d.gcode"});
  browser().drag(handle("d.gcode"), handle("b.gcode"), -15, "touch");
  expect_soon([&] { return waiting().front() == "d.gcode"; }, "finger");
  expect_queue({"d.gcode", "b.gcode", "c.gcode", "a.gcode"});
  browser().click(row_button("Move down", "d.gcode"));
  expect_soon([&] { return waiting().front() == "b.gcode"; }, "button");
  browser().click(row_button("Move up", "a.gcode"));
  expect_soon([&] { return waiting().back() == "c.gcode"; }, "button");
  expect_queue({"b.gcode", "d.gcode", "a.gcode", "c.gcode"});
  browser().run("document.querySelector(arguments[0]).focus();", Json::array({handle("c.gcode")}));
  browser().press(keys::up);
  expect_soon([&] { return waiting()[2] == "c.gcode"; }, "arrow key");
  expect_soon(
      [&] {
        return browser().run("return document.querySelector('#announcer').textContent;") ==
               "c.gcode is now number 3 of 4 that wait";
      },
      "it is not said");
  expect_queue({"b.gcode", "d.gcode", "c.gcode", "a.gcode"});
  browser().press(keys::up);  // the focus is still on it
  expect_soon([&] { return waiting()[1] == "c.gcode"; }, "arrow key again");
  expect_no_complaint();
}

TEST_F(PageTest, a_held_job_waits_and_a_refused_one_says_what_to_do) {
  begin_spooler();
  open_page();
  browser().click("#held");
  choose_file("held.gcode", squares(1, 1));
  expect_text("#queue .what", "held");
  EXPECT_EQ(job("held.gcode").at("held"), true);
  browser().click(row_button("Release", "held.gcode"));
  expect_soon([&] { return job("held.gcode").at("held") == false; }, "not released");
  browser().click(row_button("Hold", "held.gcode"));
  expect_soon([&] { return job("held.gcode").at("held") == true; }, "not held");
  // Nothing starts, so that the bed can be taken for not clear again.
  clear_bed();
  browser().click(button("The bed is not clear"));
  expect_soon([&] { return state().at("printers")[0].at("bed_clear") == false; }, "still clear");
  expect_text(".card .state", "is the bed clear?");
  browser().click("#held");
  browser().click("#wanted option[value=simulated]");
  choose_file("bad.gcode", "G1 X10\nM9999\n");
  expect_job("bad.gcode", "refused");
  EXPECT_EQ(job("bad.gcode").at("wanted_printer"), "simulated");
  expect_text("#over .what", "line 2: M9999");
  expect_text("#over .advice", "upload it once more");
  choose_file("picture.gcode", squares(3, 3));
  expect_job("picture.gcode", "queued");
  expect_soon(
      [&] {
        return browser().has("#queue img") &&
               browser().run("return document.querySelector('#queue img').naturalWidth;") == 160;
      },
      "no picture");
  clear_bed();
  expect_job("picture.gcode", "printing");
  EXPECT_EQ(job("held.gcode").at("state"), "queued");
  expect_no_complaint();
}

TEST_F(PageTest, a_job_waits_for_filament_until_a_person_says_that_there_is_enough) {
  begin_spooler();
  open_page();
  const std::string field = ".card [aria-label^='Filament left']";
  const auto enter = [&](const std::string& metres) {
    browser().run("const at = document.querySelector(arguments[0]); at.focus(); at.select();",
                  {field});
    browser().press(metres.empty() ? keys::backspace : metres);
    browser().press(keys::tab);
  };
  const auto left = [&] { return state().at("printers")[0].at("filament_mm"); };
  enter("0.01");
  expect_soon([&] { return left() == 10; }, "not taken");
  choose_file("part.gcode", squares(2, 4));
  expect_job("part.gcode", "queued");
  clear_bed();
  expect_text(".card .state", "too little filament");
  expect_text(".card .advice", "part.gcode needs 0.02 m, 0.01 m is left");
  enter("1.5");
  expect_job("part.gcode", "printing");
  expect_soon([&] { return left() == 1500; }, "not taken");
  enter("");
  expect_soon([&] { return left().is_null(); }, "an empty field is not known");
  expect_no_complaint();
}

// With Tab, Enter, blank and arrow keys alone.
TEST_F(PageTest, everything_is_reached_and_used_by_keyboard) {
  begin_spooler();
  open_page();
  choose_file("part.gcode", squares(4, 8));
  expect_job("part.gcode", "queued");
  const auto focused = [&] {
    return browser()
        .run(
            "const at = document.activeElement;"
            "return at.getAttribute('aria-label') || at.id || at.textContent;")
        .get<std::string>();
  };
  std::vector<std::string> order;
  const auto tab_to = [&](const std::string& wanted) {
    for (int i = 0; i < 40; ++i) {
      if (focused() == wanted) return;
      browser().press(keys::tab);
      order.push_back(focused());
    }
    ADD_FAILURE() << wanted << " is not reached: " << testing::PrintToString(order);
  };
  open_page();  // with the focus at its begin
  expect_text("#queue .name", "part.gcode");
  tab_to("Skip to the queue");
  browser().press(keys::enter);
  expect_soon([&] { return focused() == "queue-title"; }, "not skipped");
  browser().press(keys::tab);
  EXPECT_EQ(focused(), "files");
  open_page();
  expect_text("#queue .name", "part.gcode");
  tab_to("Emergency stop: simulated");
  tab_to("The bed is clear: simulated");
  browser().press(keys::enter);
  expect_job("part.gcode", "printing");
  tab_to("Pause: simulated");
  browser().press(keys::space);
  expect_job("part.gcode", "paused");
  tab_to("Resume: simulated");
  browser().press(keys::enter);
  expect_job("part.gcode", "printing");
  tab_to("Layer of simulated");
  tab_to("Console");
  browser().press(keys::enter);
  tab_to("What simulated says");
  tab_to("Line for simulated");
  browser().press(std::string("M118 by keyboard") + keys::enter);
  expect_text(".lines", "by keyboard");
  tab_to("files");
  tab_to("held");
  tab_to("For which printer");
  tab_to("Cancel: part.gcode");
  browser().press(keys::enter);
  expect_text("#question", "Cancel the print of part.gcode?");
  EXPECT_EQ(focused(), "no");  // what a hasty Enter does
  tab_to("yes");
  browser().press(keys::enter);
  expect_job("part.gcode", "cancelled");
  expect_soon([&] { return focused() == "Show the path: part.gcode"; }, "its row loses the focus");
  tab_to("theme");
  browser().press("dark");
  expect_soon(
      [&] { return browser().run("return document.documentElement.dataset.theme;") == "dark"; },
      "no dark theme");
  expect_no_complaint();
}

TEST_F(PageTest, a_key_is_asked_for_and_a_wrong_one_again) {
  const auto file = written("key", "0123456789abcdef\n");
  std::filesystem::permissions(file, std::filesystem::perms::owner_read);
  begin_spooler({"--key", file.string()});
  open_page_only();
  expect_soon(
      [&] { return browser().run("return !document.querySelector('#key-form').hidden;") == true; },
      "not asked");
  EXPECT_THAT(browser().text("#connection"), HasSubstr("connecting"));
  browser().type("#key", "a wrong key" + std::string(keys::enter));
  expect_text("#connection", "key is missing or wrong");
  expect_soon(
      [&] { return browser().run("return !document.querySelector('#key-form').hidden;") == true; },
      "not asked again");
  browser().clear("#key");
  browser().type("#key", "0123456789abcdef");
  browser().click("#key-form button");
  expect_soon([&] { return browser().text("#connection") == "live"; }, "not accepted");
  expect_text(".card h2", "simulated");
}

}  // namespace
}  // namespace browser_test
