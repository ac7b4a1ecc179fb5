// SPDX-License-Identifier: Apache-2.0
// A mutation that does not apply must be reported, or it would count as caught or
// survived without reason.
#include "tools/proof/mutation.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace {

proof::Mutation mutation(const std::string& from, const std::string& to) {
  proof::Mutation result;
  result.name = "m";
  result.list = "mutations/x.toml";
  result.file = "rtl/x.vhd";
  result.from = from;
  result.to = to;
  return result;
}

TEST(mutation, replaces_its_text) {
  EXPECT_EQ(proof::mutated("a <= b and c;", mutation("b and c", "b")), "a <= b;");
}

TEST(mutation, is_refused_where_its_text_is_missing_or_stands_twice_or_stays) {
  EXPECT_THROW(proof::mutated("a <= b;", mutation("c", "d")), std::runtime_error);
  EXPECT_THROW(proof::mutated("a <= b; c <= b;", mutation("<= b", "<= d")), std::runtime_error);
  EXPECT_THROW(proof::mutated("aaa", mutation("aa", "b")), std::runtime_error);
  EXPECT_THROW(proof::mutated("a <= b;", mutation("b", "b")), std::runtime_error);
}

TEST(mutation, names_the_list_and_the_file_when_refused) {
  try {
    proof::mutated("a <= b;", mutation("c", "d"));
    FAIL() << "a text that is not there was found";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("mutations/x.toml: mutation m "));
    EXPECT_THAT(error.what(), testing::HasSubstr("rtl/x.vhd"));
  }
}

}  // namespace
