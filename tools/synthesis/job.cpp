// SPDX-License-Identifier: Apache-2.0
// Calls the scripts of tools/hardware that synthesise and place, and reports what came out.
#include "tools/synthesis/job.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tools/files/path_lock.hpp"
#include "tools/files/write_text.hpp"
#include "tools/process/process.hpp"
#include "tools/synthesis/all_boards.hpp"
#include "tools/synthesis/device.hpp"
#include "tools/synthesis/obstacles.hpp"
#include "tools/synthesis/quartus.hpp"
#include "tools/synthesis/report.hpp"

namespace synthesis {
namespace {

// The calls of tools/hardware for a board and a device.
class Scripts {
 public:
  Scripts(const Options& options, const std::filesystem::path& project,
          const std::filesystem::path& firmware, const std::filesystem::path& directory,
          const std::function<void()>& look)
      : options_(options),
        device_(device_named(options.device)),
        project_(project),
        firmware_(firmware),
        directory_(directory),
        look_(look) {}

  void synthesize() const {
    const bool alone = options_.board == "core";
    // A board's firmware comes into the layout (see pack()), and the core needs none.
    std::vector<std::string> words{
        script("synthesize_board.sh", "synthesize_ice40.sh"), project_.string(), options_.board,
        device_.family == Family::ecp5 ? "-" : options_.device, directory_.string()};
    words.push_back(fmt::format("-gmemory_size_bytes={}",
                                alone ? device_.memory_bytes : options_.memory_bytes));
    if (options_.debug) words.emplace_back("-ghas_debug=true");
    if (options_.zbb) words.emplace_back("-ghas_zbb=true");
    call(words);
  }

  void place(std::uint32_t seed, const std::filesystem::path& folder) const {
    call({script("place_board.sh", "place_ice40.sh"), project_.string(), options_.board,
          directory_.string(), options_.device, std::to_string(seed), folder.string(),
          firmware_.string()});
  }

  // The firmware into the layout that is there.
  void pack() const {
    if (!std::filesystem::exists(directory_ / "layout.config")) {
      throw std::runtime_error(fmt::format("{} has no layout: without --firmware-only one is made",
                                           directory_.string()));
    }
    call({script("pack_bitstream.sh", ""), (directory_ / "layout.config").string(),
          (directory_ / "contents.hex").string(), firmware_.string(),
          (directory_ / (options_.board + ".bit")).string()});
  }

 private:
  void call(const std::vector<std::string>& words) const {
    if (process::run({.arguments = words}, {}, look_).exit_status != 0) {
      throw std::runtime_error("the synthesis failed");
    }
  }

  std::string script(const char* of_ecp5, const char* of_ice40) const {
    const char* name = device_.family == Family::ecp5 ? of_ecp5 : of_ice40;
    return (project_ / "tools/hardware" / name).string();
  }

  const Options& options_;
  const Device& device_;
  const std::filesystem::path& project_;
  const std::filesystem::path& firmware_;
  const std::filesystem::path& directory_;
  const std::function<void()>& look_;
};

// A firmware that is put into the layout or project of another chip would not start.
void require_same_memory(const Options& options, const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "synthesis.json";
  const std::optional<std::uint32_t> there = memory_of(file);
  if (!there || *there == options.memory_bytes) return;
  throw std::runtime_error(
      fmt::format("{}: the chip there has {} KiB of memory, and the firmware is for {}: omit "
                  "--firmware-only",
                  file.string(), *there / 1024, options.memory_bytes / 1024));
}

}  // namespace

void add_options(CLI::App& job, Options& options) {
  auto* board = job.add_option("board", options.board,
                               "ulx3s (ECP5); de2_115 or de2_70 (Cyclone): the project for "
                               "Quartus; or core: the processor with its memory alone")
                    ->check(CLI::IsMember({"ulx3s", "de2_115", "de2_70", "core"}))
                    ->type_name("BOARD");
  auto* all = job.add_flag("--all", options.all, "all of them, each into a folder of its name")
                  ->excludes(board);
  job.callback([board, all] {
    if (board->count() + all->count() == 0) throw CLI::RequiredError("BOARD or --all");
  });
  job.add_option("--pins", options.pins,
                 "of de2_70: reprap_2012, the pins of the original printer (by default those of "
                 "the interface board)")
      ->check(CLI::IsMember({"reprap_2012"}))
      ->excludes(all);
  job.add_option("--device", options.device,
                 "the FPGA: ECP5 12k, 25k, 45k or 85k (or 12f, ...); for core also an iCE40, "
                 "hx8k or up5k, with 4 KiB of memory")
      ->transform(CLI::Transformer(
          std::map<std::string, std::string>{
              {"12f", "12k"}, {"25f", "25k"}, {"45f", "45k"}, {"85f", "85k"}},
          CLI::ignore_case))
      ->check(CLI::IsMember({"12k", "25k", "45k", "85k", "hx8k", "up5k"}))
      ->capture_default_str();
  job.add_option("--seed", options.seed, "seed of the placement; the clock rate varies with it")
      ->capture_default_str();
  job.add_option("--seeds", options.seeds,
                 "number of placements, from --seed on; the fastest becomes the bitstream")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  job.add_option("--machine", options.machine,
                 "description of the machine: its firmware, and a chip with its memory_kib (not "
                 "core; by default that of the build)")
      ->check(CLI::ExistingFile)
      ->type_name("TOML");
  job.add_flag("--debug", options.debug, "the chip with its JTAG debug port (not core)");
  job.add_flag("--zbb,!--no-zbb", options.zbb,
               "the processor with extension Zbb, for firmware that is compiled for it");
  job.add_flag(
         "--firmware-only", options.firmware_only,
         "the firmware into what an earlier synthesis has left in the folder, in seconds: into "
         "the bitstream, with the same layout, or into the project for Quartus")
      ->excludes(all);
  job.add_option("--directory", options.directory,
                 "folder for the bitstream, synthesis.json and the tools' logs")
      ->type_name("DIR")
      ->capture_default_str();
  job.footer(
      "Exit status: 0 the bitstream is there and fast enough, or the Quartus project and the "
      "chip fits; 1 the clock or a pin is too slow, or it does not fit; 2 a tool failed. Device "
      "and seeds are for ECP5 and iCE40.");
}

bool synthesize(const Options& options, const std::filesystem::path& project,
                const std::filesystem::path& firmware, const std::function<void()>& look) {
  if (options.all) return synthesize_all(options, project, firmware, look);
  if (!options.pins.empty()) {
    Options variant = options;
    variant.board += "_" + options.pins;
    variant.pins.clear();
    if (!has_cyclone(project, variant.board)) {
      throw std::runtime_error(fmt::format("{} has no pins {}", options.board, options.pins));
    }
    return synthesize(variant, project, firmware, look);
  }
  const Device& device = device_named(options.device);
  const bool alone = options.board == "core";
  if (options.firmware_only && alone) throw std::runtime_error("core has no firmware");
  if (options.debug && alone) throw std::runtime_error("the processor alone has no debug port");
  if (!options.machine.empty() && alone) {
    throw std::runtime_error("core has no machine: its program is not for a printer");
  }
  if (device.family != Family::ecp5 && !alone) {
    throw std::runtime_error(fmt::format("{} has an ECP5; an {} is only possible for core",
                                         options.board, name_of(device.family)));
  }
  if (const std::string obstacle = obstacle_to(options, project); !obstacle.empty()) {
    throw std::runtime_error(obstacle);
  }
  std::filesystem::create_directories(options.directory);
  const std::filesystem::path directory = std::filesystem::canonical(options.directory);
  // The tools' files there would be mixed with those of another synthesis.
  const files::PathLock lock(directory,
                             "wait for its end, or choose another folder with --directory");
  if (options.firmware_only) require_same_memory(options, directory);
  if (has_cyclone(project, options.board)) {
    return make_quartus_project(options, project, firmware, directory, look);
  }
  const Scripts scripts(options, project, firmware, directory, look);
  if (options.firmware_only) {
    scripts.pack();
    fmt::print("{} has the firmware, and the layout that was there\n",
               (directory / (options.board + ".bit")).string());
    return true;
  }
  for (const char* of_before : {"layout.config", "synthesis.json"}) {
    std::filesystem::remove(directory / of_before);
  }
  scripts.synthesize();
  Report report;
  std::vector<Placement> placements;
  for (std::uint32_t seed = options.seed; seed < options.seed + options.seeds; ++seed) {
    const std::filesystem::path folder = directory / fmt::format("seed_{}", seed);
    scripts.place(seed, folder);
    const Report placed = read_report(directory, folder, device.family);
    placements.push_back({.seed = seed, .fastest_mhz = placed.fastest_mhz});
    if (placed.fastest_mhz <= report.fastest_mhz) continue;
    report = placed;
    for (const std::string& name : {options.board + ".bit", std::string("layout.config")}) {
      if (!std::filesystem::exists(folder / name)) continue;
      std::filesystem::copy_file(folder / name, directory / name,
                                 std::filesystem::copy_options::overwrite_existing);
    }
  }
  report.board = options.board;
  report.device = options.device;
  report.has_debug = options.debug;
  report.memory_bytes = alone ? device.memory_bytes : options.memory_bytes;
  report.placements = placements;
  files::write_text(directory / "synthesis.json", as_json(report));
  fmt::print("{}", as_table(report));
  fmt::print("  report, logs and, for a board, the bitstream in {}\n", directory.string());
  if (!report.pins_are_good()) {
    fmt::print(stderr, "failed: the pins are not as constraints/signals.csv and delays.csv ask\n");
  }
  return report.fast_enough() && report.pins_are_good();
}

}  // namespace synthesis
