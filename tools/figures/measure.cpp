// SPDX-License-Identifier: Apache-2.0
// One call, its result, the day and the machine.
#include "tools/figures/measure.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <thread>

#include "tools/figures/selection.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace figures {

namespace {

constexpr std::size_t shown_characters = 2000;

std::string today() {
  return fmt::format("{:%Y-%m-%d}",
                     std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
}

std::string this_machine() {
  const std::string text = files::text_of("/proc/cpuinfo");
  std::smatch match;
  const bool found = std::regex_search(text, match, std::regex(R"(model name\s*: (.*))"));
  return fmt::format("{}, {} cores", found ? match[1].str() : "unknown processor",
                     std::thread::hardware_concurrency());
}

nlohmann::json json_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(fmt::format("{} was not written", file.string()));
  return nlohmann::json::parse(stream);
}

}  // namespace

Record measure(const Group& group, const Place& place) {
  const std::filesystem::path folder = place.build / "figures" / group.name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::filesystem::path result = folder / group.result, output = folder / "output";
  const std::map<std::string, std::string> names{
      {"stepfabric", (place.build / "bin" / "stepfabric").string()},
      {"bin", (place.build / "bin").string()},
      {"build", place.build.string()},
      {"folder", folder.string()},
      {"result", result.string()}};
  process::Start call{
      .arguments = {}, .folder = place.project, .output = output, .has_input = false};
  for (const std::string& word : group.command) call.arguments.push_back(filled_in(word, names));
  const int status = process::run(call, {}, place.look).exit_status;
  const std::string said = files::text_of(output);
  if (status > group.highest_status) {
    const std::size_t begin = said.size() - std::min(said.size(), shown_characters);
    throw std::runtime_error(fmt::format("{}\n{} failed with status {}", said.substr(begin),
                                         group.command_text(), status));
  }
  Record record{.command = group.command_text(),
                .measured = today(),
                .machine = group.of_machine ? this_machine() : "",
                .values = {}};
  const auto json = group.result.empty() ? nlohmann::json() : json_of(result);
  for (const auto& [name, path] : group.paths) record.values[name] = number_at(json, path);
  for (const auto& [name, expression] : group.matches) {
    record.values[name] = number_in(said, expression);
  }
  for (const auto& [file, place_in_project] : group.pictures) {
    std::filesystem::copy_file(folder / file, place.project / place_in_project,
                               std::filesystem::copy_options::overwrite_existing);
  }
  return record;
}

}  // namespace figures
