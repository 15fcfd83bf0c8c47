// SPDX-License-Identifier: BSD-3-Clause
#include "plot/canvas/deflate.h"

#include <zlib.h>

#include <new>

namespace boxplus::app {

std::string zlib_compressed(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int status = compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                              reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  if (status != Z_OK) throw std::bad_alloc();  // the only way to fail, because `packed` is large enough
  packed.resize(size);
  return packed;
}

}  // namespace boxplus::app
