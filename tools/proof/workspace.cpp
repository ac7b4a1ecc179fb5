// SPDX-License-Identifier: Apache-2.0
// Calls of the weaver, GHDL and Yosys.
#include "tools/proof/workspace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "tools/proof/mutation.hpp"
#include "tools/proof/process.hpp"

namespace proof {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds tool_limit{300};

void write(const fs::path& file, const std::string& text) {
  std::ofstream stream(file);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

void run_tool(const std::vector<std::string>& arguments, const fs::path& folder,
              const fs::path& log) {
  const ProcessResult result = run_process(arguments, folder, log, tool_limit);
  if (result.exit_status != 0) {
    constexpr std::size_t last_words = 2000;
    const std::string text = text_of(log.string() + ".err");
    throw std::runtime_error(fmt::format(
        "{}\n{} {} in {}", text.substr(text.size() - std::min(text.size(), last_words)),
        arguments.front(), result.timed_out ? "took too long" : "failed", folder.string()));
  }
}

}  // namespace

Folders copied(const fs::path& project, const fs::path& work) {
  const Folders folders{fs::absolute(work) / "project", fs::absolute(work)};
  fs::remove_all(work);
  for (const char* folder : {"rtl", "testbench", "tools"}) {
    fs::create_directories(folders.project / folder);
    fs::copy(project / folder, folders.project / folder, fs::copy_options::recursive);
  }
  return folders;
}

void put_in_place(const fs::path& lists, const std::vector<fs::path>& stand_ins, SourceTree& tree) {
  for (const fs::path& stand_in : stand_ins) {
    const fs::path file = lists / stand_in;
    if (!tree.has(stand_in.stem().string()) || !fs::exists(file)) {
      throw std::runtime_error(
          fmt::format("{} stands in for no source, or is not there", file.string()));
    }
    tree.replace(stand_in.stem().string(), file, text_of(file));
  }
}

void write_mutated(const Folders& folders, const Mutation& mutation, const fs::path& copy) {
  write(copy, mutated(text_of(folders.project / mutation.file), mutation));
}

void prepare_sources(const Folders& folders, const fs::path& sources, const Mutation* mutation,
                     Purpose purpose) {
  fs::create_directories(sources);
  fs::path rtl = folders.project / "rtl";
  if (mutation != nullptr) {
    rtl = sources.parent_path() / "mutated";
    fs::copy(folders.project / "rtl", rtl, fs::copy_options::recursive);
    const fs::path inside = fs::relative(mutation->file, "rtl");
    write_mutated(folders, *mutation, rtl / inside);
  }
  std::vector<std::string> weaver{
      (folders.project / "tools" / "hardware" / "weave_properties.sh").string(), rtl.string(),
      folders.list().string(), sources.string()};
  if (purpose == Purpose::simulator) weaver.emplace_back("simulation");
  run_tool(weaver, sources.parent_path(), sources.parent_path() / "weave.log");
}

fs::path analyse(const Folders& folders, const fs::path& sources,
                 const std::vector<fs::path>& stand_ins, const std::string& unit,
                 const fs::path& folder) {
  const fs::path library = folder / "library";
  fs::create_directories(library);
  const auto ghdl = [&](const char* command, const std::vector<std::string>& rest,
                        const char* log) {
    std::vector<std::string> arguments{"ghdl", command, "--std=08", "-fpsl",
                                       "--workdir=" + library.string()};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    run_tool(arguments, folder, folder / log);
  };
  SourceTree tree({sources, folders.project / "testbench"});
  put_in_place(folders.list(), stand_ins, tree);
  if (!tree.has(unit)) throw std::runtime_error(fmt::format("there is no file {}.vhd", unit));
  std::vector<std::string> files;
  for (const std::string& name : tree.closure_of(unit)) {
    files.push_back(tree.file_of(name).string());
  }
  ghdl("import", files, "import.log");
  ghdl("make", {unit}, "make.log");
  return library;
}

SolverInput make_solver_input(const Folders& folders, const fs::path& sources, const Proof& proof,
                              const std::string* property, const fs::path& folder) {
  const fs::path library = analyse(folders, sources, proof.stand_ins, proof.entity, folder);
  std::vector<std::string> synthesis{"ghdl",
                                     "synth",
                                     "--std=08",
                                     "-fpsl",
                                     "--workdir=" + library.string(),
                                     "--no-assert-cover",
                                     "--out=verilog"};
  for (const auto& [name, value] : proof.generics) {
    synthesis.push_back(fmt::format("-g{}={}", name, value));
  }
  synthesis.push_back(proof.entity);
  run_tool(synthesis, folder, folder / "netlist.v");

  SolverInput input;
  const std::string verilog = text_of(folder / "netlist.v");
  const Choice choice = property != nullptr
                            ? Choice{.only = {*property},
                                     .except = {},
                                     .free = proof.free,
                                     .free_copies = proof.free_copies}
                            : Choice{proof.only, proof.except, proof.free, proof.free_copies};
  input.netlist = make_formal(verilog, proof.entity, choice);
  // GHDL names a module by its entity and, where there are generics, something more. Whether there
  // is what is to be free is asked at the beginning: what has no output left and nothing to prove
  // is gone later.
  std::string checks, cuts;
  const auto free = [&](const std::string& selection) {
    checks += fmt::format("select -assert-min 1 {}; ", selection);
    cuts += fmt::format("cutpoint {}; ", selection);
  };
  for (const std::string& entity : proof.free) free(fmt::format("t:{0} t:{0}_*", entity));
  for (const std::string& copy : proof.free_copies) free(fmt::format("c:*{}_*", copy));
  const std::string prepare = fmt::format("prep -top {};", proof.entity);
  write(folder / "formal.v", input.netlist.verilog);
  input.file = folder / "formal.smt2";
  // What belongs to other properties than a mutation's only costs time, and so does every
  // name that GHDL gives: gone at once, they take half of it with them. Proofs keep the names
  // for their traces.
  const bool is_mutation = property != nullptr;
  run_tool({"yosys", "-q", "-p",
            fmt::format("read_verilog -formal -sv formal.v; hierarchy -top {0}; {1}{2} {3}"
                        "flatten; opt_clean {4}; {5} opt -full {4}; async2sync; chformal -lower; "
                        "dffunmap; write_smt2 -wires formal.smt2; memory_map; opt -full {4}; "
                        "write_rtlil formal.il",
                        proof.entity, checks, is_mutation ? "proc;" : prepare, cuts,
                        is_mutation ? "-purge" : "", is_mutation ? prepare : "")},
           folder, folder / "yosys.log");
  return input;
}

}  // namespace proof
