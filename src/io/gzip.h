// SPDX-License-Identifier: BSD-3-Clause
// Packs and unpacks gzip (RFC 1952).
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "boxplus/base/function_ref.h"
#include "boxplus/io/text_sink.h"

namespace boxplus {

/// Whether a file is in gzip, from its first bytes.
inline bool begins_as_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b\x08");
}

/// Whether a file is written in gzip, from its name.
inline bool is_gzip_name(std::string_view path) {
  return path.ends_with(".gz");
}

/// Passes the packed text to a sink, which must outlive this object. finish() must be the last call.
class GzipPacker {
 public:
  explicit GzipPacker(TextSink sink);
  ~GzipPacker();
  void write(std::string_view text) { pack(text, false); }
  void finish() { pack({}, true); }

 private:
  struct Stream;
  void pack(std::string_view text, bool is_end);

  TextSink sink_;
  std::unique_ptr<Stream> stream_;
};

/// Passes the text of a packed file to a sink. `next` returns the next bytes of the file; none at its end.
/// The file may consist of several members. Throws FileError, with `path` as the name of the file, if the
/// file is damaged or ends early.
void unpack_gzip(const std::string& path, detail::FunctionRef<std::string_view()> next, TextSink sink);

}  // namespace boxplus
