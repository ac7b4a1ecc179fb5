// SPDX-License-Identifier: Apache-2.0
// Counts lines of lists.
#include "tools/proof/campaign_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>
#include <vector>

#include "tools/files/write_text.hpp"
#include "tools/proof/campaign_report.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

constexpr const char* introduction = R"(# Mutation score

Written by `./stepfabric prove --mutants --record` from the lists in this folder; a test compares
it with them. *Not tried* is what a sample left out. *Refused* mutants do not compile or cannot be
synthesized; *equivalent* are those that are proved to be, or judged with a reason in `FILE.toml`.
The score is killed of killed and surviving.

| file | made | not tried | refused | killed | equivalent | surviving | score |
|---|---|---|---|---|---|---|---|
)";

struct Row {
  Count count;
  int untried = 0;

  int made() const {
    return untried + count.refused + count.counted() + count.proved_equivalent +
           count.judged_equivalent;
  }
};

struct Line {
  std::string fate, by, id;
};

std::vector<Line> lines_of(const fs::path& list) {
  std::vector<Line> lines;
  std::ifstream stream(list);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find('\t');
    const std::size_t second = line.find('\t', first + 1);
    if (second == std::string::npos) {
      throw std::runtime_error(
          fmt::format("{}: a line is no `fate TAB by TAB mutant`: {}", list.string(), line));
    }
    lines.push_back({line.substr(0, first), line.substr(first + 1, second - first - 1),
                     line.substr(second + 1)});
  }
  return lines;
}

void add(const Line& line, const fs::path& list, Row& row) {
  const std::map<std::string, int*> counters{
      {not_tried, &row.untried},
      {name_of(Fate::killed), &row.count.killed},
      {name_of(Fate::refused), &row.count.refused},
      {name_of(Fate::proved_equivalent), &row.count.proved_equivalent},
      {name_of(Fate::judged_equivalent), &row.count.judged_equivalent},
      {name_of(Fate::surviving), &row.count.surviving}};
  const auto counter = counters.find(line.fate);
  if (counter == counters.end()) {
    throw std::runtime_error(fmt::format("{}: `{}` is no fate", list.string(), line.fate));
  }
  ++*counter->second;
}

std::string text_of(const std::string& name, const Row& row) {
  const std::string score =
      row.count.counted() == 0 ? "" : fmt::format("{:.1f} %", row.count.score() * 100);
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", name, row.made(), row.untried,
                     row.count.refused, row.count.killed,
                     row.count.proved_equivalent + row.count.judged_equivalent, row.count.surviving,
                     score);
}

}  // namespace

std::string summary_of(const fs::path& folder) {
  std::vector<fs::path> lists;
  for (const auto& file : fs::directory_iterator(folder)) {
    if (file.path().extension() == ".tsv") lists.push_back(file.path());
  }
  std::ranges::sort(lists);
  std::string text = introduction;
  std::string survivors;
  Row all;
  for (const fs::path& list : lists) {
    Row row;
    for (const Line& line : lines_of(list)) {
      add(line, list, row);
      add(line, list, all);
      if (line.fate == name_of(Fate::surviving)) {
        survivors += fmt::format("    {} ({})\n", line.id, line.by);
      }
    }
    text += text_of(fmt::format("`{}`", list.stem().string()), row);
  }
  text += text_of("**all**", all);
  if (survivors.empty()) return text + "\nNone of those that were tried survives.\n";
  return text + "\nSurviving, and what they were tried on:\n\n" + survivors;
}

void write_summary(const fs::path& folder) {
  const fs::path file = folder / "RESULTS.md";
  files::write_text(file, summary_of(folder));
}

}  // namespace proof
