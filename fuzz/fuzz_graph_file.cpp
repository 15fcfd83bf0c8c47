// SPDX-License-Identifier: BSD-3-Clause
// A fuzz target that checks properties of the file reader and writer, for arbitrary input texts:
//
//   - If the reader reads a text, it either returns a graph or throws an InputError.
//   - The lenient reader never throws, except for BAL, because a BAL file has no lines to skip, and for JSON,
//     because it skips elements with wrong values, but cannot go on if the text is not JSON.
//   - If the strict reader accepts a text, the lenient reader returns the same graph, with any number of
//     threads.
//   - If a graph is written and read again, the result is the same graph, and writing it gives the same text.
//     (For BAL, only the observations are compared, because the conversion of poses causes rounding errors.)
//   - If the fields of a line of data are read, written and read again, writing them gives the same text.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <optional>

#include "boxplus/base/error.h"
#include "boxplus/io/data.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

/// The text and the chi2 of a graph, which serve to compare graphs. chi2 is compared with a tolerance,
/// because the order of the summation may differ. A graph that the writer refuses has no text to compare.
struct Trace {
  std::string text, compared;
  double chi2;
  bool is_refused = false;

  bool operator==(const Trace& other) const {
    const bool same_sum = chi2 == other.chi2 || std::abs(chi2 - other.chi2) <= 1e-12 * std::abs(chi2) ||
                          (std::isnan(chi2) && std::isnan(other.chi2));
    return is_refused == other.is_refused && compared == other.compared && same_sum;
  }
};

/// The data of a line, unless the line is no data or is malformed.
std::optional<Data> data_of(const GraphFile::KeptLine& line) {
  try {
    return parse_data(line, "fuzz");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void check_data(const GraphFile& file) {
  for (const GraphFile::KeptLine& line : file.kept) {
    const std::optional<Data> data = data_of(line);
    if (!data) continue;
    const std::string written = format_data(*data);
    const std::optional<Data> again = data_of({line.place, line.after, written});
    if (again && format_data(*again) == written) continue;
    std::fprintf(stderr, "broken law: data that is read again is the same\n%s\n", written.c_str());
    std::abort();
  }
}

/// The writer refuses a graph if rounding of the pose changes a reprojection error, as with a camera at 1e16
/// or a point at the center of its camera.
Trace trace_of_bal(const GraphFile& file) {
  std::string written;
  try {
    written = format_graph(file);
  } catch (const InvalidArgument&) {
    return Trace{"", "", 0, true};
  }
  std::size_t end = 0;
  for (std::size_t line = 0; line <= file.graph.edge_count(); ++line) end = written.find('\n', end) + 1;
  return Trace{written, written.substr(0, end), 0};
}

std::optional<Trace> trace_of(std::string_view text, const ReadOptions& options) {
  try {
    const GraphFile file = parse_graph(text, "fuzz", options);
    check_data(file);
    if (file.format == "BAL") return trace_of_bal(file);
    const std::string written = format_graph(file);
    return Trace{written, written, file.graph.chi2()};
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

/// Whether the text of a graph, which was read in one format, is recognized as the format in which it was
/// written: its own, or one of those with the tags of the registry.
bool is_read_as_written(std::string_view read, std::string_view recognized) {
  constexpr std::string_view kTagged[] = {"g2o", "TORO", "Gm2dl"};
  const bool is_own = read == "BAL" || read == "json";
  return is_own ? recognized == read
                : std::find(std::begin(kTagged), std::end(kTagged), recognized) != std::end(kTagged);
}

bool is_packed(std::string_view text) {
  return text.starts_with("\x1f\x8b");
}

/// Reads a text that is packed by gzip. If it is damaged, not even lenient reading can go on.
void read_packed(std::string_view text) {
  try {
    check_data(parse_graph(text, "fuzz"));
  } catch (const Error&) {
  }
}

void check(std::string_view text) {
  if (is_packed(text)) return read_packed(text);
  ReadOptions strict, lenient;
  strict.threads = 1;
  lenient.threads = 2;
  lenient.lenient = true;
  const std::optional<Trace> strictly = trace_of(text, strict), leniently = trace_of(text, lenient);
  if (strictly)
    expect_same("if strict reading accepts a text, lenient reading gives the same graph", strictly,
                leniently);
  const FileFormat* format = default_formats().recognize(text);
  if (!leniently && (format->name == "BAL" || format->name == "json" || !format->read)) return;
  if (!leniently) expect_same("lenient reading never throws", Trace{}, leniently);
  if (leniently->is_refused) return;
  // A kept line may become the first line, and may look like that of another format.
  if (is_packed(leniently->text) ||
      !is_read_as_written(format->name, default_formats().recognize(leniently->text)->name))
    return;
  const std::optional<Trace> again = trace_of(leniently->text, strict);
  if (again && again->is_refused) return;
  expect_same("a written graph does not change when it is read again", leniently, again);
}

}  // namespace
}  // namespace boxplus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  boxplus::check({reinterpret_cast<const char*>(data), size});
  return 0;
}
