// SPDX-License-Identifier: Apache-2.0
// Formats: W3C, "Portable Network Graphics (PNG) Specification (Third Edition)", chunks acTL, fcTL and fdAT.
#include "facies/results/apng.hpp"

#include <cstdint>
#include <string_view>
#include <vector>
#include <zlib.h>

#include "facies/base/error.hpp"

namespace facies::results {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t chunk_frame =
    12;  ///< bytes of a chunk around its data: length, type, checksum

void put(std::string& text, std::uint32_t value, int n_bytes = 4) {
  for (int shift = 8 * (n_bytes - 1); shift >= 0; shift -= 8)
    text += static_cast<char>(value >> static_cast<unsigned>(shift) & 0xFFU);
}

std::uint32_t get(std::string_view text) {
  std::uint32_t value = 0;
  for (const char c : text.substr(0, 4))
    value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

void put_chunk(std::string& png, std::string_view type, std::string_view data) {
  put(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = png.size();
  png.append(type).append(data);
  const uLong checksum = crc32(0, reinterpret_cast<const Bytef*>(png.data() + begin),
                               static_cast<uInt>(png.size() - begin));
  put(png, static_cast<std::uint32_t>(checksum));
}

/// What is taken over from a PNG file.
struct Picture {
  std::string_view header;             ///< width, height, kind of pixel
  std::vector<std::string_view> data;  ///< compressed, in as many chunks as in the file
};

Picture read_chunks(std::string_view png) {
  require(png.starts_with(signature), "to_apng: not a PNG file");
  Picture picture;
  for (std::size_t place = signature.size(); place < png.size();) {
    require(png.size() - place >= chunk_frame, "to_apng: a PNG file ends too early");
    const std::size_t length = get(png.substr(place));
    require(png.size() - place - chunk_frame >= length, "to_apng: a PNG file ends too early");
    const std::string_view type = png.substr(place + 4, 4);
    const std::string_view data = png.substr(place + 8, length);
    if (type == "IHDR") picture.header = data;
    if (type == "IDAT") picture.data.push_back(data);
    place += length + chunk_frame;
  }
  require(picture.header.size() == 13 && !picture.data.empty(),
          "to_apng: a PNG file without picture");
  return picture;
}

}  // namespace

std::string to_apng(std::span<const AnimationFrame> frames) {
  require(!frames.empty(), "to_apng: no frames");
  const std::string header(read_chunks(frames.front().png).header);
  std::string png(signature);
  put_chunk(png, "IHDR", header);
  std::string control;
  put(control, static_cast<std::uint32_t>(frames.size()));
  put(control, 0);  // again and again
  put_chunk(png, "acTL", control);
  std::uint32_t number = 0;
  for (const AnimationFrame& frame : frames) {
    const Picture picture = read_chunks(frame.png);
    require(picture.header == header, "to_apng: frames differ in size or kind of pixel");
    require(frame.milliseconds > 0 && frame.milliseconds < 65536, "to_apng: 1 to 65535 ms");
    const bool is_first = number == 0;
    std::string about;
    put(about, number++);
    about.append(header, 0, 8);  // width and height
    put(about, 0);               // the whole picture: offsets in x and y
    put(about, 0);
    put(about, static_cast<std::uint32_t>(frame.milliseconds), 2);
    put(about, 1000, 2);
    put(about, 0, 2);  // what was there is not cleared, and replaced
    put_chunk(png, "fcTL", about);
    for (const std::string_view data : picture.data) {
      std::string numbered;
      if (!is_first) put(numbered, number++);
      numbered.append(data);
      put_chunk(png, is_first ? "IDAT" : "fdAT", numbered);
    }
  }
  put_chunk(png, "IEND", "");
  return png;
}

}  // namespace facies::results
