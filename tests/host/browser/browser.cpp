// SPDX-License-Identifier: Apache-2.0
// WebDriver's requests.
#include "tests/host/browser/browser.hpp"

#include <signal.h>

#include <chrono>
#include <fstream>
#include <regex>
#include <thread>

#include "host/web/http.hpp"
#include "tools/files/file_text.hpp"

namespace browser_test {

using namespace std::chrono_literals;

namespace {

constexpr auto start_limit = 60s, answer_limit = 60s, element_limit = 10s;
constexpr const char* element_key = "element-6066-11e4-a52e-4f735466cecf";  // of the standard

std::string decoded(const std::string& base64) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : base64) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) break;
    bits = (bits << 6u | static_cast<unsigned>(digit)) & 0xFFFFu;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFFu);
  }
  return bytes;
}

// Chromium's own sandbox cannot be made by root, nor in a container that permits no namespaces.
const std::vector<std::string> chromium_options{
    "--headless=new",
    "--remote-debugging-pipe",  // it ends with the driver
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--hide-scrollbars",
    "--force-color-profile=srgb",
    "--force-device-scale-factor=1",
    "--window-size=1240,1000",
    "--disable-background-networking",
    "--no-first-run"};

}  // namespace

Browser::Browser() {
  const auto log = folder_.path() / "driver.log";
  driver_ = std::make_unique<process::Process>(
      process::Start{.arguments = {"env", "HOME=" + folder_.path().string(),
                                   "XDG_CONFIG_HOME=" + (folder_.path() / "config").string(),
                                   "chromedriver", "--port=0"},
                     .output = log,
                     .has_input = false});
  std::smatch found;
  for (const auto end = std::chrono::steady_clock::now() + start_limit; port_ == 0;) {
    const std::string said = files::text_of(log);
    if (std::regex_search(said, found, std::regex("successfully on port ([0-9]+)"))) {
      port_ = std::stoi(found[1]);
    }
    if (std::chrono::steady_clock::now() > end || driver_->ending()) {
      throw BrowserError("chromedriver does not start: " + said);
    }
    std::this_thread::sleep_for(20ms);
  }
  const Json session = call("POST", "",
                            {{"capabilities",
                              {{"alwaysMatch",
                                {{"browserName", "chrome"},
                                 {"timeouts", {{"script", 30'000}, {"implicit", 10'000}}},
                                 {"goog:loggingPrefs", {{"browser", "ALL"}}},
                                 {"goog:chromeOptions", {{"args", chromium_options}}}}}}}});
  session_ = session.at("sessionId");
}

Browser::~Browser() {
  try {
    call("DELETE", "");
  } catch (const std::exception&) {  // the driver's end ends the browser too
  }
}

Json Browser::call(const std::string& method, const std::string& path, const Json& body) {
  httplib::Client client("127.0.0.1", port_);
  client.set_read_timeout(answer_limit);
  const std::string whole = "/session" + (session_.empty() ? "" : "/" + session_) + path;
  httplib::Result answer;
  if (method == "GET") answer = client.Get(whole);
  if (method == "DELETE") answer = client.Delete(whole);
  if (method == "POST") answer = client.Post(whole, body.dump(), "application/json");
  if (!answer) throw BrowserError("chromedriver does not answer " + path);
  Json value = Json::parse(answer->body, nullptr, false);
  if (value.is_discarded()) throw BrowserError("no JSON: " + answer->body);
  value = value.value("value", Json());
  if (answer->status == 200) return value;
  throw BrowserError(path + " " + body.dump() + ": " + value.value("message", answer->body));
}

Json Browser::element(const std::string& selector) {
  return call("POST", "/element", {{"using", "css selector"}, {"value", selector}});
}

std::string Browser::element_path(const std::string& selector, const std::string& more) {
  return "/element/" + element(selector).at(element_key).get<std::string>() + more;
}

void Browser::open(const std::string& address) { call("POST", "/url", {{"url", address}}); }

void Browser::set_size(int width, int height) {
  devtools("Emulation.setDeviceMetricsOverride",
           {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

// What moves between the driver's look and its click is missed.
void Browser::click_once(const std::string& selector) {
  const Json found = element(selector);
  run("window.isClicked = arguments[0].matches('option');"
      "arguments[0].addEventListener('click', () => { isClicked = true; }, {capture: true});",
      Json::array({found}));
  call("POST", "/element/" + found.at(element_key).get<std::string>() + "/click");
  if (run("return isClicked;") != true) throw BrowserError("click missed: " + selector);
}

// Where the page redraws or moves an element meanwhile, the action is repeated.
void Browser::repeat(const std::function<void()>& action, const std::function<void()>& recover) {
  for (const auto end = std::chrono::steady_clock::now() + element_limit;;) {
    try {
      action();
      return;
    } catch (const BrowserError& error) {
      const std::string_view why = error.what();
      const bool may_change = why.contains("stale element") || why.contains("intercepted") ||
                              why.contains("not interactable") || why.contains("click missed");
      if (!may_change || std::chrono::steady_clock::now() > end) throw;
    }
    recover();
  }
}

void Browser::click(const std::string& selector) {
  repeat([&] { click_once(selector); },
         [&] {
           run("document.querySelector(arguments[0])?.scrollIntoView({block: 'center'});",
               Json::array({selector}));
         });
}

void Browser::type(const std::string& selector, const std::string& text) {
  call("POST", element_path(selector, "/value"), {{"text", text}});
}

void Browser::press(const std::string& text) {
  Json actions = Json::array();
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
    do {
      ++end;  // bytes of one character
    } while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u);
    for (const char* type : {"keyDown", "keyUp"}) {
      actions.push_back({{"type", type}, {"value", text.substr(begin, end - begin)}});
    }
  }
  const Json device{{"type", "key"}, {"id", "keyboard"}, {"actions", actions}};
  call("POST", "/actions", {{"actions", Json::array({device})}});
}

void Browser::clear(const std::string& selector) { call("POST", element_path(selector, "/clear")); }

void Browser::drag_once(const std::string& from, const std::string& to, int below,
                        const std::string& pointer) {
  run("document.querySelector(arguments[0]).scrollIntoView({block: 'center'});",
      Json::array({from}));
  const Json begin = element(from), end = element(to);
  const auto move = [](const Json& origin, int y, int time) {
    return Json{
        {"type", "pointerMove"}, {"duration", time}, {"origin", origin}, {"x", 0}, {"y", y}};
  };
  const Json press{{"type", "pointerDown"}, {"button", 0}},
      lift{{"type", "pointerUp"}, {"button", 0}};
  const Json device{
      {"type", "pointer"},
      {"id", pointer},
      {"parameters", {{"pointerType", pointer}}},
      {"actions", Json::array({move(begin, 0, 0), press, move(begin, 5, 50), move(end, below, 200),
                               move(end, below + 1, 50), lift})}};
  call("POST", "/actions", {{"actions", Json::array({device})}});
  call("DELETE", "/actions");
}

void Browser::drag(const std::string& from, const std::string& to, int below,
                   const std::string& pointer) {
  repeat([&] { drag_once(from, to, below, pointer); }, [&] { call("DELETE", "/actions"); });
}

Json Browser::run(const std::string& script, const Json& arguments) {
  return call("POST", "/execute/sync", {{"script", script}, {"args", arguments}});
}

Json Browser::run_async(const std::string& script) {
  return call("POST", "/execute/async", {{"script", script}, {"args", Json::array()}});
}

bool Browser::has(const std::string& selector) {
  return run("return document.querySelector(arguments[0]) !== null;", Json::array({selector}));
}

std::string Browser::text(const std::string& selector) {
  return run(
      "const found = document.querySelector(arguments[0]); return found ? found.innerText : '';",
      Json::array({selector}));
}

Json Browser::devtools(const std::string& method, const Json& parameters) {
  return call("POST", "/goog/cdp/execute", {{"cmd", method}, {"params", parameters}});
}

std::vector<std::string> Browser::complaints() {
  std::vector<std::string> texts;
  for (const Json& entry : call("POST", "/se/log", {{"type", "browser"}})) {
    if (entry.at("level") != "DEBUG" && entry.at("level") != "INFO") {
      texts.push_back(entry.at("level").get<std::string>() + " " +
                      entry.at("message").get<std::string>());
    }
  }
  return texts;
}

void Browser::save_screenshot(const std::filesystem::path& file) {
  std::ofstream(file, std::ios::binary) << decoded(call("GET", "/screenshot"));
}

}  // namespace browser_test
