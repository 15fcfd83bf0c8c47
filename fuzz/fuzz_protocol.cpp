// SPDX-License-Identifier: BSD-3-Clause
// Feeds the protocol of g2o_online. It may only refuse a command, with InputError at a place of the input.
// Laws: a stream gives the same answers and the same error in pieces of any size; an answer is complete; ids
// are bounded, and so is the graph.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "boxplus/base/error.h"
#include "protocol/protocol.h"

namespace {

using namespace boxplus;
using namespace boxplus::app;

constexpr ProtocolLimits kLimits{.max_id = 1000, .max_vertices = 20, .max_edges = 30};

void require(bool law) {
  if (!law) std::abort();
}

struct Outcome {
  std::string answers, error;
  std::int64_t line = 0;
  std::size_t vertices = 0, edges = 0;
  int solved = 0;
  bool operator==(const Outcome&) const = default;
};

Outcome run(std::string_view text, std::size_t piece) {
  Outcome outcome;
  Graph graph;
  CommandStream stream("input");
  Protocol protocol(
      graph, "input", [&] { ++outcome.solved; }, kLimits);
  try {
    for (; !text.empty(); text.remove_prefix(std::min(piece, text.size()))) {
      std::string_view received = text.substr(0, piece);
      while (const auto command = stream.next(received)) {
        std::string answer;
        protocol.execute(*command, answer);
        require(answer.empty() || (answer.starts_with("BEGIN\n") && answer.ends_with("END\n")));
        outcome.answers += answer;
      }
    }
    stream.finish();
  } catch (const InputError& error) {
    outcome.error = error.what();
    outcome.line = error.line();
    require(error.column() >= 1);
  }
  for (const VertexRef& vertex : graph.all_vertices()) require(graph.id(vertex) <= kLimits.max_id);
  outcome.vertices = graph.vertex_count();
  outcome.edges = graph.edge_count();
  return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Outcome outcome = run(text, text.size() + 1);
  std::int64_t lines = 1;
  for (const char c : text) lines += c == '\n';
  require(outcome.line <= lines);
  require(outcome.vertices <= kLimits.max_vertices && outcome.edges <= kLimits.max_edges);
  require(run(text, 1) == outcome);
  require(run(text, 7) == outcome);
  return 0;
}
