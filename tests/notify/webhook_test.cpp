// SPDX-License-Identifier: Apache-2.0
// One webhook and receivers that are slow, refuse, die and return.
#include "host/notify/webhook.hpp"

#include <gmock/gmock.h>

#include "tests/notify/receiver.hpp"
#include "tests/notify/strange_server.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using namespace std::chrono_literals;
using notify::Event;
using notify::Kind;
using notify::Webhook;
using notify::webhook_of;
using notify::WebhookAddress;
using notify::WebhookLimits;
using notify_test::Receiver;
using notify_test::StrangeServer;
using testing::ElementsAre;
using testing::HasSubstr;

class Hooked : public testing::Test {
 protected:
  void begin(const std::string& url, WebhookLimits limits = {}) {
    if (limits.pauses.first == 1000ms) limits.pauses = {.first = 5ms, .longest = 40ms};
    hook = std::make_unique<Webhook>(
        webhook_of(url),
        [this](const std::string& line) {
          const std::scoped_lock lock(mutex_);
          log_.push_back(line);
        },
        limits);
  }
  void take(const std::string& id) {
    hook->take({.kind = Kind::job_finished, .printer = "left", .job = 3, .file = "a", .id = id});
  }
  std::vector<std::string> log() {
    const std::scoped_lock lock(mutex_);
    return log_;
  }
  std::unique_ptr<Webhook> hook;

 private:
  std::mutex mutex_;
  std::vector<std::string> log_;
};

TEST_F(Hooked, events_are_posted_as_json_in_their_order) {
  Receiver receiver;
  begin(receiver.url("/hook?a=b%20c"));
  for (const char* id : {"1", "2", "3"}) take(id);
  ASSERT_TRUE(receiver.has_answered(3));
  EXPECT_THAT(receiver.values("id"), ElementsAre("1", "2", "3"));
  EXPECT_EQ(receiver.bodies().at(0).at("event"), "job_finished");
  EXPECT_EQ(receiver.bodies().at(0).at("job"), 3);
  EXPECT_EQ(receiver.targets().at(0), "/hook?a=b%20c");
  EXPECT_EQ(receiver.types().at(0), "application/json");
  EXPECT_THAT(log(), testing::IsEmpty());
}

TEST_F(Hooked, a_receiver_that_dies_and_returns_gets_what_happened_meanwhile) {
  Receiver receiver;
  begin(receiver.url());
  take("1");
  ASSERT_TRUE(receiver.has_answered(1));
  receiver.end();
  take("2");
  take("3");
  for (int i = 0; i < 1000 && log().empty(); ++i) std::this_thread::sleep_for(10ms);
  ASSERT_THAT(log(), ElementsAre(HasSubstr("tried again")));
  receiver.begin();
  ASSERT_TRUE(receiver.has_answered(3));
  EXPECT_THAT(receiver.values("id"), ElementsAre("1", "2", "3"));
}

TEST_F(Hooked, a_fault_of_the_receiver_is_tried_again_and_a_refusal_is_not) {
  Receiver receiver;
  begin(receiver.url());
  for (const int status : {500, 503, 429, 408}) {
    receiver.answer_with(status);
    const std::size_t before = receiver.bodies().size();
    take("again" + std::to_string(status));
    ASSERT_TRUE(receiver.has_answered(before + 3)) << status;
    receiver.answer_with(204);
    take("next");
    for (int i = 0; i < 6000 && receiver.values("id").back() != "next"; ++i) {
      std::this_thread::sleep_for(10ms);
    }
    ASSERT_EQ(receiver.values("id").back(), "next") << status;
  }
  for (const int status : {301, 400, 404, 410}) {
    receiver.answer_with(status);
    const std::size_t before = receiver.bodies().size();
    take("once");
    ASSERT_TRUE(receiver.has_answered(before + 1));
    receiver.answer_with(200);
    take("after");
    ASSERT_TRUE(receiver.has_answered(before + 2));
    EXPECT_EQ(receiver.values("id").at(before + 1), "after") << status;
  }
}

TEST_F(Hooked, what_waits_is_bounded_and_the_newest_are_kept) {
  Receiver receiver;
  receiver.hold();
  begin(receiver.url(), {.backlog = {.events = 3}});
  take("0");
  ASSERT_TRUE(receiver.has_begun(1));
  for (int i = 1; i <= 1000; ++i) take(std::to_string(i));
  receiver.release();
  ASSERT_TRUE(receiver.has_answered(4));
  EXPECT_THAT(receiver.values("id"), ElementsAre("0", "998", "999", "1000"));
  EXPECT_THAT(log(), ElementsAre(HasSubstr("998 old notifications were dropped")));
}

TEST_F(Hooked, old_news_are_dropped) {
  Receiver receiver;
  receiver.answer_with(500);
  begin(receiver.url(), {.backlog = {.age = 200ms}});
  take("old");
  for (int i = 0; i < 6000 && log().size() < 2; ++i) std::this_thread::sleep_for(10ms);
  receiver.answer_with(200);
  take("new");
  while (receiver.values("id").empty() || receiver.values("id").back() != "new") {
    ASSERT_TRUE(receiver.has_answered(receiver.bodies().size() + 1));
  }
  EXPECT_THAT(log(), testing::Contains(HasSubstr("1 old notifications were dropped")));
}

// Without the limit for the whole request the first connection would never end.
TEST_F(Hooked, a_receiver_that_sends_byte_by_byte_or_nothing_ends_with_the_limit) {
  for (const char* words : {"x", "HTTP/1.1 200 OK\r\n", ""}) {
    StrangeServer server(words);
    begin(server.url(), {.request = 300ms});
    take("1");
    EXPECT_TRUE(server.has_had(2)) << words;
    hook.reset();
  }
}

TEST_F(Hooked, the_end_waits_for_no_receiver) {
  Receiver receiver;
  receiver.hold();
  begin(receiver.url(), {.request = std::chrono::hours(1)});
  take("1");
  ASSERT_TRUE(receiver.has_begun(1));
  hook.reset();  // returns while the receiver still holds the request
  receiver.release();
}

TEST(Pauses, become_longer_up_to_a_bound) {
  const notify::Pauses pauses{.first = 1s, .longest = 60s};
  EXPECT_EQ(pauses.after(0), 1s);
  EXPECT_EQ(pauses.after(1), 1s);
  EXPECT_EQ(pauses.after(2), 2s);
  EXPECT_EQ(pauses.after(6), 32s);
  EXPECT_EQ(pauses.after(7), 60s);
  EXPECT_EQ(pauses.after(1'000'000), 60s);
}

TEST(WebhookAddresses, are_read_and_refused) {
  using Address = WebhookAddress;
  EXPECT_EQ(webhook_of("http://host/a?b"), (Address{.server = "http://host", .target = "/a?b"}));
  EXPECT_EQ(webhook_of("https://host:8443"),
            (Address{.server = "https://host:8443", .target = "/"}));
  EXPECT_EQ(webhook_of("http://[::1]:80?q"),
            (Address{.server = "http://[::1]:80", .target = "/?q"}));
  for (const char* wrong : {"", "host", "ftp://host/", "http://", "http://user:secret@host/",
                            "http://host:0/", "http://host:65536/", "http://host/a b",
                            "http://host/\r\nX: y", "http://host/#a", "@", "@/missing"}) {
    EXPECT_THROW(webhook_of(wrong), std::runtime_error) << wrong;
  }
}

TEST(WebhookAddresses, come_from_a_file_that_others_cannot_read) {
  const TemporaryFolder folder;
  folder.write("url", "https://host/token\n");
  const auto file = folder.path() / "url";
  const std::string text = "@" + file.string();
  std::filesystem::permissions(file, std::filesystem::perms(0640));
  EXPECT_THROW(webhook_of(text), std::runtime_error);
  std::filesystem::permissions(file, std::filesystem::perms(0600));
  EXPECT_EQ(webhook_of(text).target, "/token");
}

}  // namespace
