// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "boxplus/base/function_ref.h"
#include "boxplus/io/text_sink.h"

namespace boxplus {

/// Replaces a file atomically. `write` gets a sink for the new text. Writes directly to pipes and devices,
/// such as /dev/stdout, because they cannot be replaced. Throws FileError.
void replace_file(const std::string& path, detail::FunctionRef<void(TextSink)> write);

}  // namespace boxplus
