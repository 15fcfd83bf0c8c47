// SPDX-License-Identifier: BSD-3-Clause
#include "io/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 17;
constexpr int kGzip = 16 + MAX_WBITS;  // the largest window, and the header of gzip

/// Makes the next bytes of `text` the input of a stream, and removes them from `text`.
void feed(z_stream& stream, std::string_view& text) {
  const std::size_t count = std::min<std::size_t>(text.size(), std::numeric_limits<uInt>::max());
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));  // zlib only reads it
  stream.avail_in = static_cast<uInt>(count);
  text.remove_prefix(count);
}

/// Makes `memory` the output of a stream.
void empty(z_stream& stream, std::string& memory) {
  stream.next_out = reinterpret_cast<Bytef*>(memory.data());
  stream.avail_out = static_cast<uInt>(memory.size());
}

std::string_view written(const z_stream& stream, const std::string& memory) {
  return {memory.data(), memory.size() - stream.avail_out};
}

struct Inflater {
  Inflater() {
    if (inflateInit2(&stream, kGzip) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  z_stream stream{};
};

}  // namespace

struct GzipPacker::Stream {
  Stream() : memory(kPiece, '\0') {
    constexpr int kMemory = 8;  // zlib's default
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Stream() { deflateEnd(&stream); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  z_stream stream{};
  std::string memory;
};

GzipPacker::GzipPacker(TextSink sink) : sink_(sink), stream_(std::make_unique<Stream>()) {}
GzipPacker::~GzipPacker() = default;

void GzipPacker::pack(std::string_view text, bool is_end) {
  z_stream& stream = stream_->stream;
  do {
    feed(stream, text);
    do {
      empty(stream, stream_->memory);
      deflate(&stream, is_end ? Z_FINISH : Z_NO_FLUSH);
      if (const std::string_view packed = written(stream, stream_->memory); !packed.empty()) sink_(packed);
    } while (stream.avail_out == 0);
  } while (!text.empty());
}

void unpack_gzip(const std::string& path, detail::FunctionRef<std::string_view()> next, TextSink sink) {
  Inflater inflater;
  z_stream& stream = inflater.stream;
  std::string memory(kPiece, '\0');
  bool is_complete = false;  // whether the last member has ended
  for (std::string_view bytes = next(); !bytes.empty(); bytes = next()) {
    while (!bytes.empty()) {
      feed(stream, bytes);
      do {
        if (is_complete && inflateReset(&stream) != Z_OK) throw std::bad_alloc();  // another member follows
        empty(stream, memory);
        const int result = inflate(&stream, Z_NO_FLUSH);
        if (result == Z_MEM_ERROR) throw std::bad_alloc();
        if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
          throw FileError(path + ": cannot be unpacked: expected gzip, got damaged data");
        is_complete = result == Z_STREAM_END;
        if (const std::string_view text = written(stream, memory); !text.empty()) sink(text);
      } while (stream.avail_in > 0 || (!is_complete && stream.avail_out == 0));
    }
  }
  if (!is_complete) throw FileError(path + ": cannot be unpacked: the file ends early");
}

}  // namespace boxplus
