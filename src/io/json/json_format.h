// SPDX-License-Identifier: BSD-3-Clause
// A graph as JSON, with everything that a Graph contains (docs/graph.schema.json). The writer puts one
// element on each line. The reader accepts every JSON text that fits the schema.
#pragma once

#include <string_view>

#include "boxplus/io/file_format.h"

namespace boxplus {

FileFormat json_format();

GraphFile read_json(const TextSource& text, const ReadOptions& options);
void write_json(const GraphFileView& file, const WriteOptions& options, TextSink sink);

/// The value of the member "format", and the largest "version" that can be read.
inline constexpr std::string_view kJsonFormat = "boxplus graph";
inline constexpr int kJsonVersion = 1;

}  // namespace boxplus
