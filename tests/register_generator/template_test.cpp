// SPDX-License-Identifier: Apache-2.0
// Templates: values go where their names stand.
#include "register_generator/template.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

using register_generator::fill;

TEST(Template, puts_values_within_a_line) {
  EXPECT_EQ(fill("a @x@ b @y@\n", {{"x", "1"}, {"y", "2"}}), "a 1 b 2\n");
}

TEST(Template, indents_each_line_of_a_value_that_stands_alone) {
  EXPECT_EQ(fill("begin\n  @lines@\nend\n", {{"lines", "one;\n\ntwo;\n"}}),
            "begin\n  one;\n\n  two;\nend\n");
}

TEST(Template, leaves_no_line_where_a_value_that_stands_alone_is_empty) {
  EXPECT_EQ(fill("begin\n  @lines@\nend\n", {{"lines", ""}}), "begin\nend\n");
}

TEST(Template, takes_a_value_as_it_is) {
  EXPECT_EQ(fill("@x@ @y@\n", {{"x", "@y@"}, {"y", "2"}}), "@y@ 2\n");
}

TEST(Template, refuses_a_name_without_a_value) {
  EXPECT_THROW(fill("@nothing@\n", {}), std::logic_error);
  EXPECT_THROW(fill("a @nothing@\n", {}), std::logic_error);
  EXPECT_THROW(fill("a @ b\n", {}), std::logic_error);
}
