// SPDX-License-Identifier: Apache-2.0
// A stream and the last lines of it.
#include "host/feeder/command_file.hpp"

#include <stdexcept>

namespace feeder {

CommandFile::CommandFile(std::filesystem::path file) : path_(std::move(file)), stream_(path_) {
  if (!stream_) throw std::runtime_error("cannot read " + path_.string());
}

const std::string& CommandFile::at(std::int64_t index) {
  if (index <= read_ - static_cast<std::int64_t>(kept_.size())) {
    stream_.clear();
    stream_.seekg(0);
    kept_.clear();
    read_ = 0;
  }
  while (read_ < index) {
    std::string line;
    if (!std::getline(stream_, line)) {
      throw std::runtime_error(path_.string() + " has no command " + std::to_string(index));
    }
    if (stream_.eof()) {  // without its end: half of it may be missing
      throw std::runtime_error(path_.string() + " was cut in command " + std::to_string(read_ + 1));
    }
    kept_.push_back(std::move(line));
    if (kept_.size() > most_kept) kept_.pop_front();
    ++read_;
  }
  return kept_[static_cast<std::size_t>(static_cast<std::int64_t>(kept_.size()) - (read_ - index) -
                                        1)];
}

}  // namespace feeder
