// SPDX-License-Identifier: Apache-2.0
// A file with the number, and where it was made.
#include "host/spooler/spooler_id.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "host/queue/random_name.hpp"
#include "host/queue/store.hpp"
#include "tools/files/write_file.hpp"

namespace spooler {

namespace {

// A copy lies in another folder, or on another machine.
std::string origin_of(const std::filesystem::path& data) {
  std::string machine;
  std::getline(std::ifstream("/etc/machine-id"), machine);
  struct stat folder{};
  if (stat(data.c_str(), &folder) != 0) {
    throw std::system_error(errno, std::generic_category(), data.string());
  }
  return machine + " " + std::to_string(folder.st_ino) + " " +
         std::filesystem::canonical(data).string();
}

}  // namespace

std::string spooler_id(const std::filesystem::path& data) {
  const std::filesystem::path file = data / spooler_id_file;
  const std::string origin = origin_of(data);
  std::string id, known_origin;
  std::ifstream stream(file);
  std::getline(stream, id);
  std::getline(stream, known_origin);
  if (!id.empty() && known_origin == origin) return id;
  id = queue::random_name();
  files::write_file(file, id + "\n" + origin + "\n");
  queue::sync_folder(data);
  return id;
}

}  // namespace spooler
