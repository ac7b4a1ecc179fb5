// SPDX-License-Identifier: Apache-2.0
// What the recorder writes of each operation on files: a head, a path or bytes, a second path.
#pragma once

#include <cstdint>

namespace power_loss {

enum class Kind : std::uint32_t {
  create,  // a file: inode, path
  make_folder,  // path
  write,  // inode, number: offset, bytes
  truncate,  // inode, number: size
  sync,  // a file: inode
  sync_folder,  // path
  rename,  // inode, from, to
  exchange,  // two paths
  remove,  // path
  said,  // bytes on standard output
};

struct Head {
  static constexpr std::uint32_t right_magic = 0x5af3'c0deu;
  std::uint32_t magic = right_magic;
  Kind kind{};
  std::uint64_t inode{};
  std::uint64_t number{};
  std::uint32_t first_bytes{};
  std::uint32_t second_bytes{};
};

}  // namespace power_loss
