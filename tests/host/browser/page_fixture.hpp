// SPDX-License-Identifier: Apache-2.0
// `stepfabric spool` with a simulated printer, and its page in a browser.
#pragma once

#include <gmock/gmock.h>

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/host/browser/browser.hpp"

namespace browser_test {

// G-code that needs neither heat nor homing: so many layers of so many squares within each other.
std::string squares(int layers, int squares_of_each);

// Kinds of controls (record_controls.js) of all tests so far.
struct Controls {
  std::set<std::string> seen, used;
};
Controls& controls();

class PageTest : public testing::Test {
 protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite();
  PageTest();
  ~PageTest() override;

  static Browser& browser() { return *browser_; }
  // With this port, or with any.
  void begin_spooler(const std::vector<std::string>& more = {});
  // kill -9: feeder and printer go on.
  void kill_spooler();
  void signal_feeder(int signal);
  // It has received its first state then, and the printer answers.
  void open_page();
  // As it is, such as one that asks for a key.
  void open_page_only();
  const std::string& address() const { return address_; }
  // By the file field, as a person chooses it.
  void choose_file(const std::string& name, const std::string& text);
  std::filesystem::path written(const std::string& name, const std::string& text);
  void clear_bed();
  // The server's own state, without the browser.
  Json state() const;
  Json job(const std::string& name) const;  // null: there is none
  std::vector<std::string> waiting() const;  // names, in their order
  // These end the test by an exception where it does not fit within a minute.
  void expect_soon(const std::function<bool()>& fits, const std::string& what) const;
  void expect_text(const std::string& selector, const std::string& part) const;
  void expect_job(const std::string& name, const std::string& state) const;
  // The page shows the jobs that wait in this order.
  void expect_queue(const std::vector<std::string>& names) const;
  void expect_no_complaint() const;

 private:
  void note_controls();
  static inline std::unique_ptr<Browser> browser_;
  TemporaryFolder folder_;
  std::optional<process::Process> spooler_;
  std::string address_, listen_ = "127.0.0.1:0";
};

// A script of this folder.
std::string script(const std::string& file);
// The card's button with these words.
std::string button(const std::string& words);
// The control of a job's row with this name, as a screen reader has it.
std::string row_button(const std::string& words, const std::string& job);

}  // namespace browser_test
