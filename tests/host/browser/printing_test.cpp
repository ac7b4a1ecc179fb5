// SPDX-License-Identifier: Apache-2.0
// A job from the drop on the page to its end, and what a person does to it meanwhile.
#include "tests/host/browser/page_fixture.hpp"

namespace browser_test {
namespace {

using testing::HasSubstr;
const std::string layer_shown = "return document.querySelector('.card .path').dataset.layer;";
constexpr int most_points_between_reports = 15;  // 4 would be a second's, on an idle machine
const std::string typed_line = "return document.querySelector('.typed input').value;";

// As a desktop does it: an event that carries a file.
void drop_file(Browser& browser, const std::string& name, const std::string& text) {
  browser.run(
      "const data = new DataTransfer(); data.items.add(new File([arguments[1]], arguments[0]));"
      "for (const type of ['dragover', 'drop']) document.querySelector('#drop').dispatchEvent("
      "new DragEvent(type, {bubbles: true, cancelable: true, dataTransfer: data}));",
      Json::array({name, text}));
}

TEST_F(PageTest, a_dropped_file_is_printed_paused_resumed_cancelled_and_printed_again) {
  begin_spooler();
  open_page();
  drop_file(browser(), "part.gcode", squares(4, 8));
  expect_job("part.gcode", "queued");
  expect_text("#queue .name", "part.gcode");
  expect_text(".card .advice", "Take the print off");
  clear_bed();
  expect_job("part.gcode", "printing");
  expect_text(".card .state", "printing");
  expect_text(".card .job", "line");
  browser().click(button("Pause"));
  expect_job("part.gcode", "paused");
  expect_text(".card .state", "paused");
  expect_text(".card .advice", "Press Resume");
  browser().click(button("Resume"));
  expect_job("part.gcode", "printing");
  expect_text(".card .state", "printing");
  browser().click(button("Cancel"));
  EXPECT_THAT(browser().text("#question"), HasSubstr("Cancel the print on simulated?"));
  browser().click("#no");
  EXPECT_FALSE(browser().has("dialog[open]"));
  EXPECT_EQ(job("part.gcode").at("state"), "printing");
  browser().click(button("Cancel"));
  browser().click("#yes");
  expect_job("part.gcode", "cancelled");
  expect_text("#over .what", "cancelled");
  expect_text(".card .state", "is the bed clear?");
  browser().click(row_button("Print again", "part.gcode"));
  expect_queue({"part.gcode"});
  browser().click("#queue " + row_button("Cancel", "part.gcode"));
  expect_queue({});
  for (int i = 0; i < 2; ++i) {
    expect_text("#over", "Remove");
    const auto before = state().at("jobs").size();
    browser().click(row_button("Remove", "part.gcode"));
    expect_soon([&] { return state().at("jobs").size() < before; }, "the job is not removed");
    expect_soon(
        [&] {
          return browser().run("return document.querySelectorAll('#over li').length;") ==
                 before - 1;
        },
        "the page shows a removed job");
  }
  expect_text("#none-over", "No job has ended");
  expect_no_complaint();
}

TEST_F(PageTest, the_path_is_drawn_where_the_printer_reports_its_head) {
  begin_spooler();
  open_page();
  // More lines than the planner holds: positions are asked for 3 s after the first, between lines.
  constexpr int squares_of_layer = 9;
  choose_file("part.gcode", squares(2, squares_of_layer));
  expect_job("part.gcode", "queued");
  clear_bed();
  browser().run(script("watch_path.js"), {5 * squares_of_layer + 1});
  expect_text(".path-box .what", "Head at X");
  int agreements = 0, layer = 0;
  expect_soon(
      [&] {
        if (browser().run_async(script("head_is_on_path.js")) == true) ++agreements;
        layer = std::stoi(browser().run(layer_shown).get<std::string>());
        return agreements >= 5 && layer >= 1;
      },
      "the drawn part is not where the head is");
  // Another layer, chosen by keyboard, stays until the print is followed again.
  browser().run("document.querySelector('.card input[type=range]').focus();");
  browser().press(keys::home);
  expect_text(".path-box .what", "layer 1 of 2");
  expect_text(".path-box .what", "100 % of it printed");
  EXPECT_GT(browser().run(script("pixels_of_colour.js"), {".card .path", "accent"}), 100);
  browser().click(".path-box label");
  expect_soon([&] { return !browser().text(".path-box .what").contains("layer 1 of 2"); },
              "it does not follow");
  expect_job("part.gcode", "finished");
  expect_soon([&] { return browser().has(".path-box[hidden]"); }, "a path without a print");
  // From point to point as it was printed, not to lines that go through the same place later.
  const auto seen = browser().run("return seen;").get<std::vector<int>>();
  ASSERT_GE(seen.size(), 10u);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    EXPECT_GT(seen[i], seen[i - 1]) << testing::PrintToString(seen);
    EXPECT_LE(seen[i], seen[i - 1] + most_points_between_reports) << testing::PrintToString(seen);
  }
  browser().click(row_button("Show the path", "part.gcode"));
  expect_text("dialog .what", "layer 1 of 2");
  browser().run("document.querySelector('dialog input[type=range]').focus();");
  browser().press(keys::right);
  expect_text("dialog .what", "layer 2 of 2");
  browser().click("#path-close");
  EXPECT_FALSE(browser().has("dialog[open]"));
  expect_no_complaint();
}

TEST_F(PageTest, temperatures_come_with_their_course_and_duty) {
  begin_spooler();
  open_page();
  browser().click("summary");
  browser().type(".typed input", "M104 S60");
  browser().press(keys::enter);
  expect_text(".heater .target", "target 60 °C");
  expect_soon([&] { return state().at("printers")[0].at("hotend")[2].get<double>() > 0.05; },
              "no duty");
  expect_soon(
      [&] {
        const std::string duty = browser().text(".heater .duty");
        return duty.starts_with("duty ") && duty != "duty 0 %";
      },
      "no duty on the page");
  const auto label = [&] {
    return browser()
        .run("return document.querySelector('.chart').getAttribute('aria-label');")
        .get<std::string>();
  };
  expect_soon([&] { return label().contains("Hotend of simulated, last 2 minutes: from"); },
              "no course");
  // Values at the pointer, with a dot on the line.
  for (const char* chart : {"[aria-label^='Hotend of']", "[aria-label^='Bed of']"}) {
    const auto ink = [&] {
      return browser().run(script("pixels_of_colour.js"), {chart, "ink"}).get<int>();
    };
    const int before = ink();
    browser().drag(chart, chart, 1, "mouse");
    EXPECT_GT(ink(), before + 10);
    browser().drag("h1", "h1", 1, "mouse");
    EXPECT_LT(ink(), before + 10);
  }
  const std::string count = "return cards.get('simulated').charts.hotend.samples.length;";
  expect_soon([&] { return browser().run(count) >= 3; }, "no samples");
  // What was before is there again when the page is opened again.
  const auto first = [&] {
    return browser()
        .run("return cards.get('simulated').charts.hotend.samples[0][0];")
        .get<double>();
  };
  const double before = first();
  open_page();
  expect_soon([&] { return browser().run(count) >= 3 && first() <= before + 2500; },
              "the course begins again");
  expect_no_complaint();
}

TEST_F(PageTest, the_console_shows_replies_and_refuses_what_would_spoil_a_print) {
  begin_spooler();
  open_page();
  browser().click("summary");
  const auto say = [&](const std::string& line) {
    browser().clear(".typed input");
    browser().type(".typed input", line);
    browser().click(".typed button");
  };
  say("M115");
  expect_text(".lines", "> M115");
  expect_text(".lines", "FIRMWARE_NAME:StepFabric");
  say("M105");
  expect_text(".lines", "T:2");
  say("M114");
  expect_text(".lines", "Count X:");
  say("M110 N1");
  expect_text(".refused", "line numbers are the feeder's");
  EXPECT_EQ(browser().run(typed_line), "M110 N1");
  browser().clear(".typed input");
  browser().type(".typed input", keys::up);
  EXPECT_EQ(browser().run(typed_line), "M114");
  choose_file("part.gcode", squares(4, 8));
  expect_job("part.gcode", "queued");
  clear_bed();
  expect_job("part.gcode", "printing");
  say("G1 X100");
  expect_text(".refused", "could spoil the print: pause it first");
  say("M220 S90");
  expect_text(".lines", "> M220 S90");
  expect_soon([&] { return browser().text(".refused").empty(); }, "it is still refused");
  EXPECT_THAT(browser().text(".lines"), testing::Not(HasSubstr("> G1 X100")));
}

TEST_F(PageTest, a_person_decides_about_a_print_that_was_interrupted) {
  begin_spooler();
  open_page();
  choose_file("part.gcode", squares(4, 8));
  const auto interrupt = [&] {
    expect_job("part.gcode", "queued");
    clear_bed();
    expect_job("part.gcode", "printing");
    expect_text(".card .state", "printing");
    browser().click(button("Switch off and on"));
    expect_text("#question", "Its print ends");
    browser().click("#yes");
    expect_job("part.gcode", "interrupted");
    expect_text(".card .state", "interrupted");
    expect_text("#queue .advice", "print it again from its beginning, or give it up");
  };
  interrupt();
  browser().click(row_button("Print again", "part.gcode"));
  interrupt();
  browser().click(row_button("Give up", "part.gcode"));
  expect_job("part.gcode", "cancelled");
  expect_text(".card .state", "is the bed clear?");
  expect_no_complaint();
}

TEST_F(PageTest, the_emergency_stop_is_in_reach_anywhere_and_stops_at_once) {
  begin_spooler();
  open_page();
  choose_file("part.gcode", squares(4, 8));
  for (int i = 0; i < 12; ++i) choose_file("later" + std::to_string(i) + ".gcode", "M105\n");
  expect_job("part.gcode", "queued");
  clear_bed();
  expect_job("part.gcode", "printing");
  browser().set_size(360, 640);
  browser().run("scrollTo(0, document.body.scrollHeight);");
  browser().click(".stop");
  EXPECT_GT(browser().run("return scrollY;"), 300) << "it was scrolled to the button";
  expect_job("part.gcode", "failed");
  expect_text("#over", "stopped by a person");
  expect_text(".card .state", "does not answer");
  expect_text(".card .advice", "press “Switch off and on”");
  browser().click(button("Switch off and on"));
  expect_text(".card .state", "is the bed clear?");
}

TEST_F(PageTest, a_question_stops_neither_the_page_nor_the_emergency_stop) {
  begin_spooler();
  open_page();
  choose_file("part.gcode", squares(4, 8));
  expect_job("part.gcode", "queued");
  clear_bed();
  expect_text(".card .job", "line");
  browser().click(button("Cancel"));
  expect_text("#question", "Cancel the print");
  const std::string then = browser().text(".card .job");
  expect_soon([&] { return browser().text(".card .job") != then; }, "the page stands still");
  browser().click("#question .stop");
  expect_job("part.gcode", "failed");
  expect_text("#over", "stopped by a person");
  browser().press(keys::escape);
  EXPECT_FALSE(browser().has("dialog[open]"));
  expect_soon([&] { return browser().has(".skip + #bar .stop"); }, "the bar is not back");
  expect_no_complaint();
}

}  // namespace
}  // namespace browser_test
