// SPDX-License-Identifier: BSD-3-Clause
// .g2o: lines that begin with tags. The reader and the writer work for every format with such lines.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

FileFormat g2o_format();

/// Reads and writes lines that begin with the tags of the registry.
GraphFile read_tagged_lines(const TextSource& text, const ReadOptions& options);
void write_tagged_lines(const GraphFileView& file, const WriteOptions& options, TextSink sink);

}  // namespace boxplus
