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
  expect_soon([&] { return browser().text(".path-box .what").contains("layer 3"); },
              "no third layer");
  const auto take = [](int width, int height, const char* theme, const char* name) {
    browser().set_size(width, height);
    browser().click("#theme option[value=" + std::string(theme) + "]");
    browser().run("document.activeElement.blur(); scrollTo(0, 0);");
    browser().save_screenshot(picture_folder / name);
  };
  take(1100, 1280, "light", "page.png");
  take(390, 844, "dark", "page_phone.png");
  expect_no_complaint();
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
