// SPDX-License-Identifier: Apache-2.0
// Forms as clients send them, however they are cut, and what is none.
#include "host/web/multipart.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace {

using web::MultipartError;
using web::MultipartReader;
using Parts = std::vector<std::pair<std::string, std::string>>;  // name, perhaps file name; data

struct Form {
  Parts parts;
  bool is_whole = false;
};

// In pieces of so many bytes.
Form read(const std::string& body, std::size_t piece, const std::string& boundary = "x") {
  Form form;
  MultipartReader reader(
      boundary,
      [&](const MultipartReader::Part& part) {
        form.parts.emplace_back(part.file_name ? part.name + "=" + *part.file_name : part.name, "");
      },
      [&](std::string_view data) { form.parts.back().second += data; });
  for (std::size_t at = 0; at < body.size(); at += piece) reader.take(body.substr(at, piece));
  form.is_whole = reader.is_whole();
  return form;
}

std::string part(const std::string& disposition, const std::string& data) {
  return "--x\r\nContent-Type: text/plain\r\nContent-Disposition: form-data; " + disposition +
         "\r\n\r\n" + data + "\r\n";
}

std::string name_of(const std::string& disposition) {
  return read(part(disposition, "") + "--x--", 1000).parts.at(0).first;
}

TEST(multipart, is_the_same_however_it_is_cut) {
  const std::string good =
      "before\r\n" + part(R"(name="print")", "true") +
      part(R"(name="file"; filename="a.gcode")", "G28\r\n-x not\r\n-\r\r\n--\r\n--") +
      part("name=empty", "") + "--x  \t--\r\nbehind";
  for (std::size_t piece = 1; piece <= good.size(); ++piece) {
    const Form form = read(good, piece);
    EXPECT_EQ(form.parts, (Parts{{"print", "true"},
                                 {"file=a.gcode", "G28\r\n-x not\r\n-\r\r\n--\r\n--"},
                                 {"empty", ""}}))
        << piece;
    EXPECT_TRUE(form.is_whole) << piece;
    EXPECT_FALSE(read(good.substr(0, good.size() - 9), piece).is_whole);
  }
}

TEST(multipart, reads_names_as_browsers_slicers_and_curl_send_them) {
  EXPECT_EQ(name_of(R"(name="file"; filename="a;b.gcode")"), "file=a;b.gcode");
  EXPECT_EQ(name_of(R"(NAME=file ;FileName = "a=b, c.gcode" ; x=y)"), "file=a=b, c.gcode");
  EXPECT_EQ(name_of(R"(name="file"; filename="a\"b\\c.gcode")"), "file=a\"b\\c.gcode");
  EXPECT_EQ(name_of(R"(name="file"; filename="C:\parts\a.gcode")"), "file=C:\\parts\\a.gcode");
  EXPECT_EQ(name_of(R"(name="file"; filename="x"; filename*=UTF-8''D%C3%BCse%3b.gcode)"),
            "file=D\xC3\xBCse;.gcode");
  EXPECT_EQ(name_of(R"(name="file"; filename="x"; filename*=UTF-8''%zz)"), "file=x");
  EXPECT_EQ(name_of(R"(name="a; filename=b")"), "a; filename=b");
}

TEST(multipart, takes_a_delimiter_wherever_it_is) {
  EXPECT_THROW(read(part("name=a", "data\r\n--x not") + "--x--", 1000), MultipartError);
}

TEST(multipart, refuses_what_can_be_read_in_two_ways_or_not_at_all) {
  for (const char* disposition :
       {R"(name="a"; name="b")", R"(name="a"; filename="b"; filename="c")", R"(name="a)",
        R"(filename="a")"}) {
    EXPECT_THROW(name_of(disposition), MultipartError) << disposition;
  }
  for (const std::string& body :
       {std::string("--x\r\nno colon\r\n\r\ndata\r\n--x--"),
        std::string("--x\r\n\r\ndata\r\n--x--\r\n\r\n"),
        std::string("--x\r\nContent-Type: a/b\r\n\r\ndata\r\n--x--"),
        std::string("--x\r\nContent-Disposition: attachment; name=a\r\n\r\n\r\n--x--"),
        std::string("--x\r\nContent-Disposition: form-data; name=a\r\nContent-Disposition: "
                    "form-data; name=b\r\n\r\n\r\n--x--"),
        "--x\r\nContent-Disposition: form-data; name=" + std::string(9000, 'a'),
        std::string(9000, ' ') + "--x--", std::string("--x?\r\n")}) {
    EXPECT_THROW(read(body, 100), MultipartError) << body.substr(0, 80);
  }
}

TEST(multipart, refuses_much_that_follows_its_end) {
  const std::string form = part("name=a", "data") + "--x--";
  const std::size_t most = MultipartReader::longest_head;
  EXPECT_TRUE(read(form + std::string(most, ' '), 100).is_whole);
  EXPECT_THROW(read(form + std::string(most + 1, ' '), 100), MultipartError);
  EXPECT_THROW(read("--x--" + std::string(most + 1, ' '), 7), MultipartError);
  const std::string before = std::string(most - 2, ' ') + "\r\n";
  EXPECT_TRUE(read(before + form + std::string(most, ' '), 100).is_whole)
      << "each end has its own limit";
}

TEST(multipart, takes_boundaries_of_printable_characters) {
  EXPECT_EQ(web::boundary_of("multipart/form-data; boundary=\"a b;c\"; charset=x"), "a b;c");
  EXPECT_EQ(web::boundary_of("multipart/form-data;BOUNDARY=x"), "x");
  EXPECT_EQ(web::boundary_of("multipart/form-data; boundary="), std::nullopt);
  EXPECT_EQ(web::boundary_of("multipart/form-data; xboundary=x"), std::nullopt);
  EXPECT_EQ(web::boundary_of("multipart/form-data; boundary=\x01"), std::nullopt);
  EXPECT_EQ(web::boundary_of("multipart/form-data; boundary=" + std::string(300, 'x')),
            std::nullopt);
}

}  // namespace
