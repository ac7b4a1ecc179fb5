// SPDX-License-Identifier: Apache-2.0
// A headless Chromium, driven over WebDriver (W3C) through Debian's chromedriver.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "tools/process/process.hpp"

namespace browser_test {

using Json = nlohmann::json;

// What WebDriver refuses, such as a click on what is not there or covered.
struct BrowserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Elements are named by CSS selectors; the first one counts. What is done to one waits up to 10 s
// until it is there. Every call throws BrowserError.
class Browser {
 public:
  Browser();
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  void open(const std::string& address);
  // Of the page's area, in CSS pixels.
  void set_size(int width, int height);
  // As a person does, when it is visible; it is scrolled to, from under the bar too.
  void click(const std::string& selector);
  // Into this element. For a file field: a path.
  void type(const std::string& selector, const std::string& text);
  // Keys of the keyboard, one after the other, wherever the focus is.
  void press(const std::string& keys);
  void clear(const std::string& selector);
  // From the middle of one to so many pixels below the middle of the other; the pointer is
  // "mouse", "pen" or "touch".
  void drag(const std::string& from, const std::string& to, int below, const std::string& pointer);
  // Of JavaScript: `return …;`.
  Json run(const std::string& script, const Json& arguments = Json::array());
  Json run_async(const std::string& script);
  bool has(const std::string& selector);
  std::string text(const std::string& selector);  // what is shown; empty where there is none
  // Of the Chrome DevTools protocol.
  Json devtools(const std::string& method, const Json& parameters = Json::object());
  // What the page's console and the browser have complained of since the last call.
  std::vector<std::string> complaints();
  void save_screenshot(const std::filesystem::path& file);

 private:
  Json call(const std::string& method, const std::string& path, const Json& body = Json::object());
  Json element(const std::string& selector);
  void repeat(const std::function<void()>& action, const std::function<void()>& recover);
  void click_once(const std::string& selector);
  void drag_once(const std::string& from, const std::string& to, int below,
                 const std::string& pointer);
  std::string element_path(const std::string& selector, const std::string& more);

  TemporaryFolder folder_;
  std::unique_ptr<process::Process> driver_;
  int port_ = 0;
  std::string session_;
};

// Keys of WebDriver that are no characters.
namespace keys {
inline constexpr const char* backspace = "\uE003";
inline constexpr const char* tab = "\uE004";
inline constexpr const char* enter = "\uE007";
inline constexpr const char* escape = "\uE00C";
inline constexpr const char* space = " ";
inline constexpr const char* up = "\uE013";
inline constexpr const char* right = "\uE014";
inline constexpr const char* down = "\uE015";
inline constexpr const char* home = "\uE011";
}  // namespace keys

}  // namespace browser_test
