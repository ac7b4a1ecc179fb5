// SPDX-License-Identifier: Apache-2.0
// Figures are taken from results into pages, and errors are detected.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/temporary_folder.hpp"
#include "tools/figures/expression.hpp"
#include "tools/figures/measure.hpp"
#include "tools/figures/page.hpp"
#include "tools/figures/project.hpp"
#include "tools/figures/selection.hpp"
#include "tools/files/file_text.hpp"

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const figures::Store store{
    {"print",
     {"print it", "2026-11-22", "", {{"moves", 2139}, {"edges", 299'372}, {"mm", 0.01138}}}},
    {"link", {"time it", "2026-11-22", "", {{"rate", 1'234'567.8}, {"change", -12'345}}}}};

std::string shown(const std::string& expression) {
  std::set<std::string> used;
  return figures::shown(expression, store, used);
}

TEST(figure, is_shown_with_thousands_apart_and_the_decimals_asked_for) {
  EXPECT_EQ(shown("print.moves"), "2139");
  EXPECT_EQ(shown("print.edges"), "299 372");
  EXPECT_EQ(shown("link.rate:1"), "1 234 567.8");
  EXPECT_EQ(shown("link.change"), "-12 345");
  EXPECT_EQ(shown(" print.mm * 1000 : 1 "), "11.4");
  EXPECT_EQ(shown("(print.edges - print.moves * 2) / 2 + 1:0"), "147 548");
}

TEST(figure, that_does_not_exist_or_cannot_be_read_is_refused) {
  for (const char* bad :
       {"print.speed", "serve.moves", "print", "", "print.moves +", "(print.moves",
        "print.moves print.moves", "print.mm", "print.mm:x", "print.mm:99"}) {
    EXPECT_THROW(shown(bad), std::runtime_error) << bad;
  }
}

const nlohmann::json result = nlohmann::json::parse(R"({
  "queue": {"underruns": 0, "text": "12.5"},
  "axes": {"x": {"steps": 3}, "y": {"steps": 9}},
  "rates": [{"baud": 250, "window": 1, "busy": 25}, {"baud": 250, "window": 2, "busy": 34}],
  "works": [{"name": "core", "clocks": 7}]})");

TEST(selection, follows_members_indices_conditions_and_all) {
  EXPECT_EQ(figures::number_at(result, "/queue/underruns"), 0);
  EXPECT_EQ(figures::number_at(result, "/queue/text"), 12.5);
  EXPECT_EQ(figures::number_at(result, "/rates/1/busy"), 34);
  EXPECT_EQ(figures::number_at(result, "/rates/baud=250&window=2/busy"), 34);
  EXPECT_EQ(figures::number_at(result, "/works/name=core/clocks"), 7);
  EXPECT_EQ(figures::number_at(result, "sum /axes/*/steps"), 12);
  EXPECT_EQ(figures::number_at(result, "max /axes/*/steps"), 9);
  EXPECT_EQ(figures::number_at(result, "min /rates/*/busy"), 25);
  EXPECT_EQ(figures::number_at(result, "count /rates/*"), 2);
}

TEST(selection, of_none_or_of_several_is_refused) {
  for (const char* bad : {"/queue/depth", "/rates/baud=250/busy", "/rates/7/busy", "/axes/*/steps",
                          "/queue", "mean /axes/*/steps", "underruns", "sum /none/*"}) {
    EXPECT_THROW(figures::number_at(result, bad), std::runtime_error) << bad;
  }
}

TEST(selection, in_a_text_is_what_the_expression_matches_everywhere) {
  EXPECT_EQ(figures::number_in("12 lines, 40 steps\n", "([0-9]+) steps"), 40);
  EXPECT_EQ(figures::number_in("4 steps, 4 steps", "([0-9]+) steps"), 4);
  EXPECT_THROW(figures::number_in("4 steps, 5 steps", "([0-9]+) steps"), std::runtime_error);
  EXPECT_THROW(figures::number_in("no", "([0-9]+) steps"), std::runtime_error);
}

figures::Page page_of(const std::string& text) {
  std::set<std::string> used;
  return figures::with_figures(text, store, {{"rates", "| {{link.rate:0}} | {{print.moves}} |\n"}},
                               used);
}

TEST(page, keeps_what_is_right) {
  const std::string text =
      "At 2139<!--print.moves--> moves, 299 372<!--print.edges-->; 500 others.\n\n"
      "<!-- figures: rates -->\n| 1 234 568 | 2139 |\n<!-- end -->\n\n"
      "```\n7<!--print.moves-->\n```\n";
  const figures::Page page = page_of(text);
  EXPECT_EQ(page.text, text);
  EXPECT_THAT(page.problems, IsEmpty());
}

TEST(page, shows_the_figures_of_the_file_in_the_place_of_others_which_are_reported) {
  const figures::Page page = page_of(
      "After\n12 140<!--print.moves--> moves\n<!-- figures: rates -->\n| 9 | 9 |\n<!-- end -->\n");
  EXPECT_EQ(page.text,
            "After\n2139<!--print.moves--> moves\n<!-- figures: rates -->\n"
            "| 1 234 568 | 2139 |\n<!-- end -->\n");
  EXPECT_THAT(page.problems, ElementsAre("2: 12 140 stands for print.moves, which is 2139",
                                         "3: the table rates shows other figures or words"));
}

TEST(page, with_a_figure_or_table_that_does_not_exist_keeps_its_text) {
  const std::string text =
      "7<!--print.time-->\n<!-- figures: none -->\n| 1 |\n<!-- end -->\n<!-- figures: rates -->\n";
  const figures::Page page = page_of(text);
  EXPECT_EQ(page.text, text);
  EXPECT_THAT(page.problems,
              ElementsAre(HasSubstr("1: print.time: there is no figure"),
                          HasSubstr("2: there is no table none"), HasSubstr("rates has no end")));
}

// A project with one group, which echoes its figures, and one page.
class Project : public testing::Test {
 protected:
  Project() {
    group("");
    folder.write("tools/figures/tables/rates.md", "| {{echo.clocks}} |\n");
    folder.write("README.md",
                 "7<!--echo.moves-->\n\n<!-- figures: rates -->\n| 5 |\n<!-- end -->\n");
    record();
  }
  void group(const std::string& more) {
    folder.write(
        "tools/figures/groups/echo.toml",
        "about = \"What echo says\"\nminutes = 1\nresult = \"result.json\"\n"
        "command = [\"sh\", \"-c\", \"echo 7 moves; echo '{\\\"clocks\\\": 5}' > {result}\"]\n" +
            more + "[values]\nclocks = \"/clocks\"\n[matches]\nmoves = \"([0-9]+) moves\"\n");
  }
  figures::Record measured() const {
    return figures::measure(
        figures::read_group(folder.path() / "tools/figures/groups/echo.toml"),
        {.project = folder.path(), .build = folder.path() / "build", .look = {}});
  }
  void record() const {
    folder.write("tools/figures/figures.json", figures::to_json({{"echo", measured()}}));
  }
  std::vector<std::string> problems() const {
    return figures::problems_of(figures::read_project(folder.path()));
  }
  TemporaryFolder folder;
};

TEST_F(Project, is_good_where_the_pages_show_what_was_measured) {
  const auto read = figures::read_store(figures::store_file(folder.path()));
  EXPECT_EQ(read.at("echo"), measured());
  EXPECT_EQ(read.at("echo").values.at("clocks"), 5);
  EXPECT_EQ(read.at("echo").machine, "");
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(Project, puts_pictures_into_their_place) {
  group("[pictures]\n\"result.json\" = \"picture.svg\"\n");
  measured();
  EXPECT_EQ(files::text_of(folder.path() / "picture.svg"), "{\"clocks\": 5}\n");
}

TEST_F(Project, names_the_machine_where_the_figures_depend_on_it) {
  group("of_machine = true\n");
  EXPECT_THAT(measured().machine, HasSubstr(" cores"));
}

TEST_F(Project, fails_with_a_command_that_ends_with_a_higher_status_than_the_group_accepts) {
  const auto measured_with = [this](int status, const std::string& accepted) {
    folder.write("tools/figures/groups/echo.toml",
                 fmt::format("about = \"x\"\nminutes = 1\n{}command = [\"sh\", \"-c\", \"echo 3; "
                             "exit {}\"]\n[matches]\nx = \"(3)\"\n",
                             accepted, status));
    return measured().values.at("x");
  };
  EXPECT_EQ(measured_with(0, ""), 3);
  EXPECT_THROW(measured_with(1, ""), std::runtime_error);
  EXPECT_EQ(measured_with(0, "highest_status = 1\n"), 3);
  EXPECT_EQ(measured_with(1, "highest_status = 1\n"), 3);
  EXPECT_THROW(measured_with(2, "highest_status = 1\n"), std::runtime_error);
}

TEST_F(Project, gets_the_pages_right_and_nothing_else) {
  folder.write("README.md", "8<!--echo.moves-->\n\n<!-- figures: rates -->\n<!-- end -->\n");
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("README.md:1: 8 stands for echo.moves"),
                                      HasSubstr("README.md:3: the table rates shows")));
  EXPECT_THAT(figures::update_pages(figures::read_project(folder.path())), IsEmpty());
  EXPECT_EQ(files::text_of(folder.path() / "README.md"),
            "7<!--echo.moves-->\n\n<!-- figures: rates -->\n| 5 |\n<!-- end -->\n");
}

TEST_F(Project, says_what_no_page_shows_and_what_was_measured_otherwise) {
  folder.write("README.md", "nothing\n");
  EXPECT_THAT(problems(),
              ElementsAre("echo.clocks: no page shows it", "echo.moves: no page shows it",
                          "table rates: no page shows it"));
  folder.write("tools/figures/groups/other.toml",
               "about = \"x\"\nminutes = 1\ncommand = [\"true\"]\n[matches]\nx = \"(1)\"\n");
  EXPECT_THAT(problems(), testing::Contains(HasSubstr("other has not been measured")));
  group("");
  folder.write("tools/figures/groups/echo.toml",
               "about = \"x\"\nminutes = 1\ncommand = [\"false\"]\n[matches]\nx = \"(1)\"\n");
  EXPECT_THAT(problems(), testing::Contains(HasSubstr("echo was measured with another command")));
  EXPECT_THROW(measured(), std::runtime_error);
}

TEST_F(Project, refuses_entries_that_no_group_has) {
  group("minute = 1\n");
  EXPECT_THROW(problems(), std::runtime_error);
}

}  // namespace
