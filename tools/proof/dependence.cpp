// SPDX-License-Identifier: Apache-2.0
// Digests of settings, sources, tools and judge.
#include "tools/proof/dependence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <stdexcept>

#include "tools/proof/mutation.hpp"
#include "tools/proof/process.hpp"
#include "tools/proof/vhdl_tokens.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

bool may_instruct_a_tool(std::string_view between) {
  static constexpr std::array<std::string_view, 5> words{"psl", "pragma", "synthesis", "synopsys",
                                                         "translate"};
  std::string lower(between);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::any_of(
      words, [&lower](std::string_view word) { return lower.find(word) != std::string::npos; });
}

// Parts of a text that cannot run into each other.
class Parts {
 public:
  void add(std::string_view part) { text_ += fmt::format("{}:{};", part.size(), part); }
  void add(const std::vector<std::string>& parts) {
    add(std::to_string(parts.size()));
    for (const std::string& part : parts) add(part);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string settings_of(const Proof& proof) {
  Parts parts;
  parts.add(name_of(proof.method));
  parts.add(std::to_string(proof.depth));
  parts.add(proof.entity);
  parts.add(std::to_string(proof.generics.size()));
  for (const auto& [name, value] : proof.generics) {
    parts.add(name);
    parts.add(value);
  }
  for (const auto* names :
       {&proof.only, &proof.except, &proof.free, &proof.free_copies, &proof.signals}) {
    parts.add(*names);
  }
  for (const fs::path& file : proof.stand_ins) parts.add(file.string());
  parts.add(std::to_string(proof.values));
  return parts.text();
}

}  // namespace

Versions versions_of_tools(const fs::path& folder) {
  const auto version = [&folder](const char* tool, const char* option) {
    const fs::path log = folder / fmt::format("{}_version.log", tool);
    const ProcessResult result = run_process({tool, option}, folder, log, std::chrono::minutes(1));
    const std::string text = text_of(log);
    if (result.exit_status != 0 || text.empty()) {
      throw std::runtime_error(fmt::format("{} does not say its version", tool));
    }
    return text;
  };
  return {version("ghdl", "--version"), version("yosys", "-V"), version("z3", "--version")};
}

std::string essence_of(std::string_view vhdl) {
  Parts parts;
  std::size_t end = 0;
  const auto add_between = [&](std::size_t begin) {
    const std::string_view between = vhdl.substr(end, begin - end);
    if (may_instruct_a_tool(between)) parts.add(between);
  };
  for (const Token& token : tokens_of(vhdl)) {
    add_between(token.begin);
    parts.add(vhdl.substr(token.begin, token.end - token.begin));
    end = token.end;
  }
  add_between(vhdl.size());
  return parts.text();
}

std::string text_of_the_judge(const fs::path& project) {
  static const std::regex include(R"re(#include "(tools/proof/[^"]+)")re");
  std::map<fs::path, std::string> texts;
  std::vector<fs::path> open{"tools/proof/task.cpp"};
  while (!open.empty()) {
    const fs::path file = open.back();
    open.pop_back();
    if (texts.contains(file) || !fs::exists(project / file)) continue;
    const std::string& text = texts[file] = files::text_of(project / file);
    for (std::sregex_iterator match(text.begin(), text.end(), include), last; match != last;
         ++match) {
      open.emplace_back((*match)[1].str());
      open.push_back(fs::path(open.back()).replace_extension(".cpp"));
    }
  }
  if (texts.empty()) throw std::runtime_error("there is no tools/proof/task.cpp");
  Parts parts;
  for (const auto& [file, text] : texts) {
    parts.add(file.string());
    parts.add(text);
  }
  parts.add(text_of(project / "tools" / "hardware" / "weave_properties.sh"));
  return parts.text();
}

Dependence::Woven Dependence::woven(const Folders& folders, const char* name, Purpose purpose) {
  const fs::path sources = folders.work / name / "sources";
  prepare_sources(folders, sources, nullptr, purpose);
  Woven woven{SourceTree({sources, folders.project / "testbench"}), {}};
  for (const std::string& unit : woven.tree.units()) {
    woven.digests[unit] = fingerprint(essence_of(woven.tree.text_of(unit)));
  }
  return woven;
}

Dependence::Dependence(const Folders& folders, const Versions& versions)
    : folders_(folders),
      versions_(versions),
      judge_(fingerprint(text_of_the_judge(folders.project))),
      synthesized_(woven(folders, "synthesized", Purpose::solver)),
      simulated_(woven(folders, "simulated", Purpose::simulator)) {}

std::optional<std::string> Dependence::digest_of(const Proof& proof,
                                                 const Mutation* mutation) const {
  try {
    Parts parts;
    parts.add(judge_);
    parts.add(settings_of(proof));
    if (mutation != nullptr) {
      parts.add(mutation->property);
      parts.add(std::to_string(mutation->depth));
    }
    parts.add(proof.method == Method::arithmetic ? of_lemma(proof, mutation)
                                                 : of_sources(proof, mutation));
    return fingerprint(parts.text());
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

std::string Dependence::of_lemma(const Proof& proof, const Mutation* mutation) const {
  Parts parts;
  parts.add(versions_.z3);
  const std::string text = text_of(folders_.list() / proof.lemma);
  parts.add(mutation == nullptr ? text : mutated(text, *mutation));
  return parts.text();
}

std::string Dependence::of_sources(const Proof& proof, const Mutation* mutation) const {
  const bool is_bench = proof.method == Method::bench;
  const Woven& woven = is_bench ? simulated_ : synthesized_;
  SourceTree tree = woven.tree;
  std::set<std::string> replaced;
  if (mutation != nullptr) {
    // The file with the fault, and as it is woven without one: what is woven in is the same.
    const std::string unit = mutation->file.stem().string();
    tree.replace(
        unit, tree.file_of(unit),
        mutated(text_of(folders_.project / mutation->file), *mutation) + "\n" + tree.text_of(unit));
    replaced.insert(unit);
  }
  if (!is_bench) put_in_place(folders_.list(), proof.stand_ins, tree);
  for (const fs::path& file : proof.stand_ins) replaced.insert(file.stem().string());
  Parts parts;
  parts.add(versions_.ghdl);
  if (!is_bench) {
    parts.add(versions_.yosys);
    parts.add(versions_.z3);
  }
  for (const std::string& unit : tree.closure_of(proof.entity)) {
    parts.add(unit);
    parts.add(replaced.contains(unit) ? fingerprint(essence_of(tree.text_of(unit)))
                                      : woven.digests.at(unit));
  }
  return parts.text();
}

}  // namespace proof
