// SPDX-License-Identifier: Apache-2.0
// Four bytes a pixel, one compressed block, no filters.
#include "tools/planning/png.hpp"

#include <zlib.h>

#include <stdexcept>
#include <string_view>

namespace planning {

namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (const unsigned shift : {24u, 16u, 8u, 0u})
    bytes += static_cast<char>(value >> shift & 0xFFu);
  return bytes;
}

std::string chunk(std::string_view type, const std::string& content) {
  const std::string covered = std::string(type) + content;
  const uLong sum =
      crc32(0, reinterpret_cast<const Bytef*>(covered.data()), static_cast<uInt>(covered.size()));
  return big_endian(static_cast<std::uint32_t>(content.size())) + covered +
         big_endian(static_cast<std::uint32_t>(sum));
}

std::string compressed(const std::string& rows) {
  uLongf size = compressBound(rows.size());
  std::string bytes(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(bytes.data()), &size,
               reinterpret_cast<const Bytef*>(rows.data()), rows.size()) != Z_OK) {
    throw std::runtime_error("the picture cannot be compressed");
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string png_of(const std::vector<Pixel>& pixels, std::uint32_t width, std::uint32_t height) {
  if (pixels.size() != std::size_t{width} * height)
    throw std::logic_error("no rectangle of pixels");
  std::string rows;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % width == 0) rows += '\0';  // no filter
    for (const std::uint8_t part :
         {pixels[i].red, pixels[i].green, pixels[i].blue, pixels[i].alpha}) {
      rows += static_cast<char>(part);
    }
  }
  const std::string format{8, 6, 0, 0,
                           0};  // bits of a part, with alpha, usual methods, no interlace
  return std::string("\x89PNG\r\n\x1a\n", 8) +
         chunk("IHDR", big_endian(width) + big_endian(height) + format) +
         chunk("IDAT", compressed(rows)) + chunk("IEND", "");
}

}  // namespace planning
