// SPDX-License-Identifier: BSD-3-Clause
#include "plot/graph_page.h"

#include <zlib.h>

#include <chrono>
#include <cstdint>
#include <string_view>
#include <utility>

#include "boxplus/base/error.h"
#include "viewer/server/page.h"
#include "viewer/workspace/workspace.h"

namespace boxplus::app {
namespace {

/// The element of the page that contains the messages (viewer/PROTOCOL.md).
constexpr std::string_view kPlace = R"(id="saved-stream">)";

/// Decompresses a file of gzip, whose last four bytes are its size.
std::string unzipped(std::string_view gz) {
  std::size_t size = 0;
  for (std::size_t k = 1; k <= 4; ++k) size = size << 8 | static_cast<unsigned char>(gz[gz.size() - k]);
  std::string text(size, '\0');
  std::string input(gz);  // zlib's pointers are not const
  z_stream stream{};
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  constexpr int kGzip = 16 + MAX_WBITS;
  const bool is_read = inflateInit2(&stream, kGzip) == Z_OK && inflate(&stream, Z_FINISH) == Z_STREAM_END;
  inflateEnd(&stream);
  if (!is_read) throw Error("the page of the viewer was not decompressed");
  return text;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::string_view part = bytes.substr(k, 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (i < part.size() ? static_cast<unsigned char>(part[i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= part.size() ? kDigits[bits >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

/// What a page gets that opens a stream.
std::string first_messages(GraphFile file, const std::string& name) {
  viewer::Workspace workspace;
  workspace.show(std::move(file), name);
  viewer::Workspace::Reader reader(workspace, "");
  std::string bytes;
  for (const viewer::Message& message : reader.wait(std::chrono::milliseconds(0))) bytes += *message;
  return bytes;
}

}  // namespace

std::string make_graph_page(GraphFile file, const std::string& name) {
  std::string page = unzipped(viewer::page_html_gz());
  const std::size_t place = page.find(kPlace);
  if (place == std::string::npos) throw Error("the page of the viewer has no place for a graph");
  page.insert(place + kPlace.size(), base64(first_messages(std::move(file), name)));
  return page;
}

}  // namespace boxplus::app
