// SPDX-License-Identifier: BSD-3-Clause
#include "io/toro/toro_format.h"

#include <algorithm>
#include <array>

#include "io/g2o/g2o_format.h"
#include "io/g2o/notes.h"
#include "io/line_reader.h"
#include "io/tagged_elements.h"

namespace boxplus {
namespace {

bool begins_with_tag_of_toro(std::string_view text) {
  constexpr std::array<std::string_view, 4> kTags{"VERTEX2", "EDGE2", "VERTEX3", "EDGE3"};
  return std::find(kTags.begin(), kTags.end(), first_tag(text)) != kTags.end();
}

}  // namespace

void write_pose_graph(const GraphFileView& file, const Registry& tags, TextSink sink) {
  if (file.graph.parameter_count() == 0) return write_tagged_lines(file, {.registry = &tags}, sink);
  for (const EdgeRef& edge : file.graph.all_edges()) static_cast<void>(tag_to_write(tags, file.graph, edge));
  Graph graph = file.graph;
  for (const VertexRef& parameter : graph.all_parameters()) graph.remove(parameter);
  write_tagged_lines({graph, file.edges, file.kept}, {.registry = &tags}, sink);
}

std::vector<std::string> parameter_losses(const GraphFileView& file) {
  const auto count = static_cast<std::int64_t>(file.graph.parameter_count());
  if (count == 0) return {};
  return {counted(count, "parameter", "parameters")};
}

FileFormat toro_format() {
  return {.name = "TORO",
          .extension = ".graph",
          .recognize = begins_with_tag_of_toro,
          .read = read_tagged_lines,
          .write = [](const GraphFileView& file, const WriteOptions& /*options*/,
                      TextSink sink) { write_pose_graph(file, toro_registry(), sink); },
          .losses = parameter_losses,
          .written_on_request = true};
}

}  // namespace boxplus
