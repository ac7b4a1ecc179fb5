// SPDX-License-Identifier: Apache-2.0
// Rules of the tree that a text search can check: the layout, file headers, forbidden VHDL.
#include <gmock/gmock.h>

#include <regex>

#include "tests/repository/tree.hpp"

namespace {

namespace fs = std::filesystem;
using ::files::text_of;
using repository::files;
using repository::is_generated;
using repository::project;
using repository::source_extensions;

TEST(repository, every_source_file_names_its_licence_at_the_top) {
  for (const fs::path& file : files(source_extensions)) {
    std::istringstream text(text_of(project / file));
    std::string line;
    bool found = false;
    for (int i = 0; i < 3 && std::getline(text, line); ++i) {
      found |= line.find("SPDX-License-Identifier: Apache-2.0") != std::string::npos;
    }
    EXPECT_TRUE(found) << file << " has no SPDX line within its first three lines";
  }
}

// The page is not generated, so what it says of the firmware is compared.
TEST(repository, the_page_looks_for_the_head_among_all_lines_that_the_printer_may_have_taken) {
  const auto number_in = [](const fs::path& file, const std::string& name) {
    const std::string text = text_of(project / file);
    std::smatch match;
    EXPECT_TRUE(std::regex_search(text, match, std::regex(name + " = ([0-9]+);"))) << file;
    return match.empty() ? 0 : std::stoi(match[1]);
  };
  EXPECT_GE(number_in("host/web/page/path_data.js", "mostAhead"),
            number_in("firmware/motion/planner.hpp", "capacity") +
                number_in("firmware/host_link/line_queue.hpp", "capacity"));
}

TEST(repository, every_folder_of_sources_explains_itself_in_a_readme) {
  std::set<fs::path> folders;
  for (const fs::path& file : files({".vhd", ".cpp", ".hpp", ".gcode", ".csv"})) {
    folders.insert(file.parent_path());
  }
  for (const fs::path& folder : folders) {
    const bool explained = fs::exists(project / folder / "README.md") ||
                           fs::exists(project / folder.parent_path() / "README.md");
    EXPECT_TRUE(explained) << folder << " has no README.md, nor has the folder above it";
  }
}

TEST(repository, every_link_of_a_page_leads_to_a_file) {
  const std::regex link(R"(\]\(([^)#:\s]+)(#[^)]*)?\))");
  for (const fs::path& file : files({".md"})) {
    const std::string text = text_of(project / file);
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      const fs::path target = project / file.parent_path() / (*match)[1].str();
      EXPECT_TRUE(fs::exists(target)) << file << " links to " << (*match)[1];
    }
  }
}

// Each has a plain word of the field in its place: reported, next to, again, no host, corrupts,
// ignores, fixed, fault injector, start, forever, detects, takes effect, releases, corrupts, in the
// middle of, attributed to, real time, invalid, any, ruins, gated.
TEST(repository, retired_words_stay_away) {
  const std::regex retired(
      R"((^|[^A-Za-z])(told|tells|anew|beside|nobody|whoever|spoilt|harms|harmed|deaf|)"
      R"(cured|opponent|bites|saboteur|tormentor|the begin|for ever|)"
      R"(takes hold|lets go|let be|spoils|in the midst|put down to|clock on the wall|)"
      R"(no good|somebody|anybody|per world|takes no notice|)"
      R"(edges? that may be left out)($|[^A-Za-z]))",
      std::regex::icase);
  std::set<std::string> extensions = source_extensions;
  extensions.insert({".md", ".psl", ".txt", ".csv"});
  for (const fs::path& file : files(extensions)) {
    if (file.filename() == "repository_test.cpp" || file.begin()->string() == "examples") continue;
    std::istringstream text(text_of(project / file));
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
      std::smatch match;
      EXPECT_FALSE(std::regex_search(line, match, retired))
          << file << ":" << number << ": " << match[2];
    }
  }
}

TEST(repository, every_entity_has_a_test_bench) {
  std::set<std::string> benches;
  for (const fs::path& file : files({".vhd"}, "testbench")) benches.insert(file.stem().string());
  const std::regex entity(R"((?:^|\n)entity (\w+) is)");
  for (const fs::path& file : files({".vhd"}, "rtl")) {
    if (is_generated(file)) continue;
    const std::string text = text_of(project / file);
    for (std::sregex_iterator match(text.begin(), text.end(), entity), end; match != end; ++match) {
      const std::string name = (*match)[1];
      EXPECT_TRUE(benches.contains(name + "_tb")) << file << ": entity " << name << " has no bench";
    }
  }
}

TEST(repository, every_test_bench_is_run_by_ctest) {
  for (const fs::path& file : files({".vhd"}, "testbench")) {
    if (!file.stem().string().ends_with("_tb")) continue;
    const std::string list = text_of(project / file.parent_path() / "CMakeLists.txt");
    const std::string bench = file.stem().string();
    const std::regex listed("\\b" + bench.substr(0, bench.size() - 3) + "(_tb)?\\b");
    EXPECT_TRUE(std::regex_search(list, listed))
        << file << " is not in the CMakeLists.txt of its folder";
  }
}

// What GHDL 5.0.1 synthesises wrongly or not at all, as far as a text search can find it.
TEST(repository, the_hardware_uses_no_construct_that_synthesis_gets_wrong) {
  const std::vector<std::pair<std::regex, std::string>> forbidden{
      {std::regex(R"('-')"), "don't-care literal: comes out as z"},
      {std::regex(R"('X'|'Z'|'U')"), "metavalue: comes out as z"},
      {std::regex(R"(\b(minimum|maximum)\s*\()"), "minimum/maximum: invalid Verilog for signed"},
      {std::regex(R"(\brem\b)"), "rem: wrong for signed"},
      {std::regex(
           R"(^\s*(begin|edge|end|event|force|initial|inout|input|module|output|parameter|reg|)"
           R"(release|repeat|specify|table|task|time|tri|wire)\s*:\s*(in|out|inout)\b)"),
       "port named as a keyword of Verilog: GHDL may end with INTERNAL_ERROR"},
      {std::regex(R"(shared variable)"), "shared variable: no tool infers the same memory"},
      {std::regex(R"(\b(altsyncram|altpll|EHXPLLL|DP16KD)\b)"),
       "vendor primitive outside boards/"}};
  for (const fs::path& file : files({".vhd"}, "rtl")) {
    std::istringstream text(text_of(project / file));
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
      const std::string code = line.substr(0, line.find("--"));
      for (const auto& [pattern, why] : forbidden) {
        EXPECT_FALSE(std::regex_search(code, pattern)) << file << ":" << number << ": " << why;
      }
    }
  }
}

TEST(repository, nothing_names_a_folder_of_somebodys_machine) {
  const std::regex personal(R"((^|[^A-Za-z0-9_.])/(home|root|work|Users)/)");
  std::set<std::string> extensions = source_extensions;
  extensions.insert({".md", ".txt", ".json"});
  for (const fs::path& file : files(extensions)) {
    std::istringstream text(text_of(project / file));
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
      EXPECT_FALSE(std::regex_search(line, personal)) << file << ":" << number << ": " << line;
    }
  }
}

// A test that forks itself, with no program, says so here.
TEST(repository, programs_are_started_in_one_place) {
  const std::set<std::string> forks_itself{"tests/sim/pseudo_terminal_path_test.cpp"};
  const std::regex start(R"(\b(fork|posix_spawnp?|exec[lv]p?e?|popen|std::system)\()");
  for (const fs::path& file : files({".cpp", ".hpp"})) {
    const std::string folder = file.begin()->string();
    if (folder == "firmware" || file.parent_path() == "tools/process" ||
        forks_itself.contains(file) || file.filename() == "repository_test.cpp") {
      continue;
    }
    std::smatch match;
    const std::string text = text_of(project / file);
    EXPECT_FALSE(std::regex_search(text, match, start))
        << file << " calls " << match[1] << ": tools/process starts programs";
  }
}

TEST(repository, the_firmware_logic_includes_no_hardware) {
  const std::regex hardware(R"(#include "(drivers|platform|sim)/)");
  for (const char* folder : {"firmware/units", "firmware/gcode", "firmware/motion",
                             "firmware/thermal", "firmware/host_link"}) {
    for (const fs::path& file : files({".cpp", ".hpp"}, folder)) {
      EXPECT_FALSE(std::regex_search(text_of(project / file), hardware)) << file;
    }
  }
}

// tools/timing relies on it: whatever else the program accesses lies in memory.
TEST(repository, the_firmware_makes_pointers_of_numbers_in_one_place) {
  const std::regex cast(R"((reinterpret|bit)_cast<[^;]*\*\s*>\s*\()");
  const std::set<std::string> of_pointers{"firmware/boot_loader/main.cpp",
                                          "firmware/platform/memory.cpp"};
  std::set<std::string> found;
  for (const fs::path& file : repository::files({".cpp", ".hpp"}, "firmware")) {
    if (std::regex_search(text_of(project / file), cast)) found.insert(file.string());
  }
  for (const std::string& file : of_pointers) found.erase(file);
  EXPECT_EQ(found, std::set<std::string>{"firmware/platform/bus.cpp"})
      << "platform/bus.hpp reads and writes registers";
}

}  // namespace
