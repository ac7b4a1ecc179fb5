// SPDX-License-Identifier: Apache-2.0
// Pages that a reader takes in: of a screen or so, in short paragraphs, with figures
// that a command measured.
#include <gtest/gtest.h>

#include <regex>

#include "tests/repository/tree.hpp"

namespace {

namespace fs = std::filesystem;
using repository::files;
using repository::lines_of;

// What a reader sees: without comments, and a link as its words.
std::string seen(const std::string& line) {
  static const std::regex comment("<!--[^>]*-->"), link(R"(\]\([^)]*\))");
  return std::regex_replace(std::regex_replace(line, comment, ""), link, "]");
}

std::vector<fs::path> written_pages() {
  std::vector<fs::path> pages;
  for (const fs::path& file : files({".md"})) {
    const std::string name = file.string();
    const bool is_made = name.starts_with("rtl/registers/") || file.filename() == "RESULTS.md" ||
                         name == "firmware/application/gcodes.md" ||
                         name == "boards/interface/schematic.md" ||
                         name.starts_with("tools/figures/tables/");
    if (!is_made && name != "CHANGELOG.md") pages.push_back(file);
  }
  return pages;
}

// In tables the cells, elsewhere what stands between blank lines or points of a list.
class Paragraphs {
 public:
  explicit Paragraphs(const fs::path& page) {
    for (const std::string& line : lines_of(page)) {
      ++number_;
      take(line);
    }
    end();
  }
  struct Paragraph {
    std::size_t line;
    std::size_t characters;
  };
  std::vector<Paragraph> all;

 private:
  void take(const std::string& line) {
    static const std::regex point(R"( *(-|\*|[0-9]+\.) .*)");
    is_code_ ^= line.starts_with("```");
    const bool is_apart = line.empty() || line.starts_with("|") || line.starts_with("#") ||
                          line.starts_with("    ") || line.starts_with("```");
    if (is_code_ || is_apart) {
      end();
      return;
    }
    if (std::regex_match(line, point)) end();
    if (characters_ == 0) begin_ = number_;
    characters_ += seen(line).size() + 1;
  }
  void end() {
    if (characters_ > 0) all.push_back({begin_, characters_});
    characters_ = 0;
  }

  std::size_t number_ = 0, begin_ = 0, characters_ = 0;
  bool is_code_ = false;
};

TEST(pages, have_no_paragraph_of_more_than_600_characters) {
  constexpr std::size_t most = 600;
  for (const fs::path& page : written_pages()) {
    for (const auto& [line, characters] : Paragraphs(page).all) {
      EXPECT_LE(characters, most) << page << ":" << line << ": make it two, a list, or shorter";
    }
  }
}

TEST(pages, fit_a_screen) {
  // The first page has what is needed to begin as well.
  const std::string first_page = "README.md";
  constexpr std::size_t most = 60;
  for (const fs::path& page : written_pages()) {
    if (page == first_page) continue;
    EXPECT_LE(lines_of(page).size(), most) << page << ": move a part to a page of its own";
  }
}

// A number with one of these units was measured: it is marked as a figure (tools/figures), or its
// line has a link to the source.
TEST(pages, have_no_figure_that_was_typed) {
  const std::regex figure(
      "[0-9] (steps/s|lines/s|clocks/s|step edges|LUT4|clocks per instruction|"
      "random instructions|bytes of code)");
  for (const fs::path& page : written_pages()) {
    bool is_table_of_figures = false;
    std::size_t number = 0;
    for (const std::string& line : lines_of(page)) {
      ++number;
      if (line.starts_with("<!-- figures: ")) is_table_of_figures = true;
      if (line == "<!-- end -->") is_table_of_figures = false;
      if (is_table_of_figures || line.find("](http") != std::string::npos) {
        continue;
      }
      std::smatch match;
      EXPECT_FALSE(std::regex_search(line, match, figure))
          << page << ":" << number << ": " << match[0];
    }
  }
}

}  // namespace
