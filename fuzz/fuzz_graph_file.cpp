// SPDX-License-Identifier: BSD-3-Clause
// What must hold for any text that someone takes for a graph file:
//
//   - reading it ends with a graph or with an InputError, and nothing else;
//   - lenient reading never complains, and reads what strict reading accepts as strict reading does;
//   - what was read can be written, and what was written reads back to the same text.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

void expect_same(const char* law, const std::string& expected, const std::string& actual) {
  if (expected == actual) return;
  std::fprintf(stderr, "%s\n── expected ──\n%s── got ──\n%s", law, expected.c_str(), actual.c_str());
  std::abort();
}

/// The text that writes back what was read; nothing where `text` is refused.
std::optional<std::string> read_and_write(std::string_view text, bool lenient) {
  ReadOptions options;
  options.lenient = lenient;
  try {
    const GraphFile file = parse_graph(text, "fuzz", options);
    (void)file.graph.chi2();
    return format_graph(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void check(std::string_view text) {
  const std::optional<std::string> strict = read_and_write(text, false), lenient = read_and_write(text, true);
  if (!lenient) expect_same("lenient reading does not complain", "", "an InputError\n");
  if (strict) expect_same("lenient reading accepts what strict reading does", *strict, *lenient);
  const std::optional<std::string> again = read_and_write(*lenient, false);
  expect_same("what was written reads back to the same text", *lenient, again.value_or("an InputError\n"));
}

}  // namespace
}  // namespace boxplus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  boxplus::check({reinterpret_cast<const char*>(data), size});
  return 0;
}
