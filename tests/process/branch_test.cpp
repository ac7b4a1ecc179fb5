// SPDX-License-Identifier: Apache-2.0
// A copy computes what it is given, and neither it nor its errors change this process.
#include "tools/process/branch.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <string>

namespace {

using process::Branch;

std::string error_of(const std::function<std::string()>& work) {
  try {
    return Branch(work).result();
  } catch (const std::runtime_error& error) {
    return std::string("threw ") + error.what();
  }
}

TEST(Branch, computes_from_what_is_in_memory_and_changes_nothing) {
  std::string text = "before";
  Branch first([&] { return text += " first"; });
  text = "between";
  Branch second([&] { return text += " second"; });
  EXPECT_EQ(second.result(), "between second");
  EXPECT_EQ(first.result(), "before first");
  EXPECT_EQ(text, "between");
}

TEST(Branch, returns_more_bytes_than_a_pipe_holds_of_any_value) {
  const std::string bytes(1'000'000, '\0');
  EXPECT_EQ(Branch([&] { return bytes; }).result(), bytes);
  EXPECT_EQ(Branch([] { return std::string(); }).result(), "");
}

TEST(Branch, says_how_it_has_failed) {
  EXPECT_EQ(error_of([]() -> std::string { throw std::logic_error("no paper"); }),
            "threw no paper");
  EXPECT_EQ(error_of([]() -> std::string { _exit(0); }), "threw a process ended without a result");
  EXPECT_EQ(error_of([]() -> std::string {
              raise(SIGKILL);
              return "";
            }),
            "threw a process was ended by signal 9");
}

TEST(Branch, is_gone_with_its_object) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  {
    const Branch endless([&]() -> std::string {
      for (;;) pause();
    });
  }
  close(ends[1]);
  char byte = 0;
  EXPECT_EQ(read(ends[0], &byte, 1), 0) << "it has held the other end";
  close(ends[0]);
}

}  // namespace
