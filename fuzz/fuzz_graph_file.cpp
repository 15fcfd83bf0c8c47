// SPDX-License-Identifier: BSD-3-Clause
// A fuzz target that checks properties of the file reader and writer, for arbitrary input texts:
//
//   - If the reader reads a text, it either returns a graph or throws an InputError.
//   - The lenient reader never throws, except for BAL, because a BAL file has no lines to skip.
//   - If the strict reader accepts a text, the lenient reader returns the same graph, with any number of
//     threads.
//   - If a graph is written and read again, the result is the same graph, and writing it gives the same text.
//     (For BAL, only the observations are compared, because the conversion of poses causes rounding errors.)
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

/// The text and the chi2 of a graph, which serve to compare graphs. chi2 is compared with a tolerance,
/// because the order of the summation may differ.
struct Trace {
  std::string text, compared;
  double chi2;

  bool operator==(const Trace& other) const {
    const bool same_sum = chi2 == other.chi2 || std::abs(chi2 - other.chi2) <= 1e-12 * std::abs(chi2) ||
                          (std::isnan(chi2) && std::isnan(other.chi2));
    return compared == other.compared && same_sum;
  }
};

std::optional<Trace> trace_of(std::string_view text, const ReadOptions& options) {
  try {
    const GraphFile file = parse_graph(text, "fuzz", options);
    std::string written = format_graph(file);
    if (file.format != "BAL") return Trace{written, written, file.graph.chi2()};
    std::size_t end = 0;
    for (std::size_t line = 0; line <= file.graph.edge_count(); ++line) end = written.find('\n', end) + 1;
    return Trace{written, written.substr(0, end), 0};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void print(const char* title, const std::optional<Trace>& trace) {
  if (trace) {
    std::fprintf(stderr, "── %s, chi2 %.17g ──\n%s", title, trace->chi2, trace->text.c_str());
  } else {
    std::fprintf(stderr, "── %s: an InputError ──\n", title);
  }
}

void expect_same(const char* law, const std::optional<Trace>& expected, const std::optional<Trace>& actual) {
  if (expected == actual) return;
  std::fprintf(stderr, "broken law: %s\n", law);
  print("expected", expected);
  print("got", actual);
  std::abort();
}

void check(std::string_view text) {
  ReadOptions strict, lenient;
  strict.threads = 1;
  lenient.threads = 2;
  lenient.lenient = true;
  const std::optional<Trace> strictly = trace_of(text, strict), leniently = trace_of(text, lenient);
  if (strictly)
    expect_same("if strict reading accepts a text, lenient reading gives the same graph", strictly,
                leniently);
  const FileFormat* format = default_formats().recognize(text);
  if (!leniently && (format->name == "BAL" || !format->read)) return;
  if (!leniently) expect_same("lenient reading never throws", Trace{}, leniently);
  // A kept line may become the first line, and may look like that of another format.
  const std::string& again = default_formats().recognize(leniently->text)->name;
  if ((format->name != "BAL" && again == "BAL") || again == "ply") return;
  expect_same("a written graph does not change when it is read again", leniently,
              trace_of(leniently->text, strict));
}

}  // namespace
}  // namespace boxplus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  boxplus::check({reinterpret_cast<const char*>(data), size});
  return 0;
}
