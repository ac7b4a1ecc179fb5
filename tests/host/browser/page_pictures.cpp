// SPDX-License-Identifier: Apache-2.0
// Pictures of the page in the middle of a print: page_pictures FILE.gcode FOLDER.
#include <cstdio>

#include "tests/host/browser/page_fixture.hpp"
#include "tools/files/file_text.hpp"

namespace browser_test {
namespace {

std::filesystem::path gcode_file, picture_folder;

TEST_F(PageTest, makes_the_pictures) {
  begin_spooler({"--simulation-speed", "max"});
  open_page();
  choose_file("washer.gcode", files::text_of(gcode_file));
  choose_file("hook.gcode", squares(8, 5));
  choose_file("tray.gcode", squares(2, 12));
  choose_file("not_for_this_printer.gcode", "M9999\n");
  expect_job("not_for_this_printer.gcode", "refused");
  clear_bed();
  browser().click("summary");
  for (const char* layer : {"layer 2", "layer 3"}) expect_text(".path-box .what", layer);
  for (const char* line : {"M105", "M114"}) {
    browser().type(".typed input", line + std::string(keys::enter));
    expect_text(".lines", std::string("> ") + line);
  }
  const auto take = [](int width, int height, const char* theme, const char* name) {
    browser().set_size(width, height);
    browser().run(
        "document.documentElement.dataset.theme = arguments[0];"
        "document.dispatchEvent(new Event('themechange'));"
        "document.activeElement.blur(); scrollTo(0, 0);",
        Json::array({theme}));
    browser().save_screenshot(picture_folder / name);
  };
  take(1100, 1280, "light", "page.png");
  take(390, 1240, "dark", "page_phone.png");
  expect_no_complaint();
  // For a look at what the pages do not show.
  take(1100, 1280, "dark", "wide_dark.png");
  take(390, 3000, "light", "phone_whole.png");
  browser().click(button("Cancel"));
  take(390, 844, "light", "question.png");
  browser().click("#no");
  browser().click(row_button("Show the path", "hook.gcode"));
  expect_text("dialog .what", "layer 1");
  take(390, 844, "dark", "path.png");
  browser().click("#path-close");
  kill_spooler();
  expect_text("#connection", "No connection");
  browser().click(".stop");
  expect_text("#message", "NOT stopped");
  take(390, 844, "light", "not_connected.png");
}

}  // namespace
}  // namespace browser_test

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  if (count != 3) {
    std::fputs("usage: page_pictures FILE.gcode FOLDER\n", stderr);
    return 2;
  }
  browser_test::gcode_file = arguments[1];
  browser_test::picture_folder = arguments[2];
  return RUN_ALL_TESTS();
}
