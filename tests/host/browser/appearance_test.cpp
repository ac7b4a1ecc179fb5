// SPDX-License-Identifier: Apache-2.0
// Size of the first load, a phone, contrast, and what a screen reader gets.
#include <set>

#include "tests/host/browser/page_fixture.hpp"

namespace browser_test {
namespace {

constexpr int most_bytes = 200'000;
constexpr int phone_width = 360;

class Appearance : public PageTest {
 protected:
  // With a print, a job that waits, one that is refused, an open console and a message.
  void open_full_page() {
    begin_spooler();
    open_page();
    choose_file("part_with_a_rather_long_name_that_no_line_of_a_phone_can_hold.gcode",
                squares(4, 8));
    choose_file("next.gcode", squares(2, 2));
    choose_file("bad.gcode", "M9999\n");
    expect_job("bad.gcode", "refused");
    expect_job("next.gcode", "queued");
    clear_bed();
    expect_text(".path-box .what", "layer");
    browser().click("summary");
    browser().type(".typed input", "G28" + std::string(keys::enter));
    expect_text(".refused", "Not sent");
    browser().run("show('A message that says what has failed, and what to do about it.');");
  }
};

TEST_F(Appearance, the_first_load_stays_below_200_kb) {
  begin_spooler();
  open_page();
  expect_text(".card .state", "is the bed clear?");
  const Json bytes = browser().run(script("first_load.js"));
  std::printf("first load: %d bytes on the wire, %d unpacked\n", bytes.at("wire").get<int>(),
              bytes.at("whole").get<int>());
  EXPECT_GE(bytes.at("names").size(), 3u) << bytes;  // page, style, script
  EXPECT_GT(bytes.at("whole"), 20'000);
  EXPECT_LT(bytes.at("wire"), most_bytes);
  EXPECT_LT(bytes.at("whole"), most_bytes);
  for (const Json& name : bytes.at("names")) {  // it works offline
    EXPECT_TRUE(name.get<std::string>().starts_with(address() + "/")) << name;
  }
  EXPECT_EQ(browser().run("return document.getAnimations().length;"), 0);
  expect_no_complaint();
}

TEST_F(Appearance, a_phone_of_360_pixels_never_scrolls_sideways) {
  open_full_page();
  browser().set_size(phone_width, 640);
  EXPECT_EQ(browser().run("return innerWidth;"), phone_width);
  EXPECT_EQ(browser().run(script("too_wide.js")), Json::array());
  EXPECT_LE(browser().run("return document.documentElement.scrollWidth;"), phone_width);
  EXPECT_EQ(browser().run(script("too_small.js")), Json::array());
}

TEST_F(Appearance, texts_have_the_contrast_of_level_aa_in_light_and_dark_and_when_old) {
  open_full_page();
  const auto low_contrasts = [&] { return browser().run(script("low_contrasts.js")); };
  for (const std::string theme : {"light", "dark"}) {
    browser().click("#theme option[value=" + theme + "]");
    expect_soon(
        [&] { return browser().run("return document.documentElement.dataset.theme;") == theme; },
        theme);
    EXPECT_EQ(low_contrasts(), Json::array()) << theme;
  }
  // As the system has it.
  browser().click("#theme option[value='']");
  const auto paper = [&] {
    return browser().run("return getComputedStyle(document.body).backgroundColor;");
  };
  const auto set_system = [&](const char* scheme) {
    const Json feature{{"name", "prefers-color-scheme"}, {"value", scheme}};
    browser().devtools("Emulation.setEmulatedMedia", {{"features", Json::array({feature})}});
  };
  set_system("dark");
  EXPECT_EQ(paper(), "rgb(17, 21, 28)");
  set_system("light");
  EXPECT_EQ(paper(), "rgb(246, 247, 249)");
  kill_spooler();
  expect_soon([&] { return browser().has("body.old"); }, "not old");
  EXPECT_EQ(low_contrasts(), Json::array()) << "old";
}

TEST_F(Appearance, every_control_has_a_name_of_its_own_in_the_accessibility_tree) {
  open_full_page();
  const std::set<std::string> controls{"button", "textbox", "combobox",    "checkbox",
                                       "slider", "image",   "progressbar", "log"};
  const std::set<std::string> places{"link", "article", "list", "region", "heading"};
  std::set<std::string> roles, names;
  const Json tree = browser().devtools("Accessibility.getFullAXTree");
  for (const Json& node : tree.at("nodes")) {
    const std::string role = node.at("role").value("value", "");
    if (node.value("ignored", false) || !(controls.contains(role) || places.contains(role))) {
      continue;
    }
    const std::string name = node.contains("name") ? node.at("name").value("value", "") : "";
    EXPECT_NE(name, "") << node.dump();
    roles.insert(role);
    if (role == "button") {
      EXPECT_TRUE(names.insert(name).second) << "two buttons are named " << name;
    }
  }
  for (const std::string& role : controls) EXPECT_TRUE(roles.contains(role)) << role;
  for (const char* live : {"#connection[role=status]", "#message[role=alert]",
                           "#announcer[aria-live=polite]", ".state[role=status]"}) {
    EXPECT_TRUE(browser().has(live)) << live;
  }
}

}  // namespace
}  // namespace browser_test
