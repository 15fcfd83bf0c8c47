// SPDX-License-Identifier: BSD-3-Clause
#include "files/trajectory_input.h"

#include <vector>

#include "files/graph_input.h"
#include "trajectory/tum.h"

namespace boxplus::app {
namespace {

GraphFile parse_with_notes(const std::string& text, const std::string& path, const ReadOptions& reading) {
  GraphFile file = parse_input(text, path, reading);
  print_notes(file, path);
  return file;
}

}  // namespace

Trajectory read_trajectory(const std::string& path, const ReadOptions& reading) {
  const std::string text = read_text(path), name = input_name(path);
  refuse_other_trajectory(text, name);
  if (!is_tum(text)) return trajectory_of(parse_with_notes(text, path, reading), name);
  std::vector<GraphFile::Note> skipped;
  const Trajectory trajectory = parse_tum(text, name, reading.lenient ? &skipped : nullptr);
  print_notes(skipped, path);
  return trajectory;
}

GraphFile read_truth(const std::string& path, const ReadOptions& reading) {
  const std::string text = read_text(path);
  refuse_tum(text, input_name(path));
  return parse_with_notes(text, path, reading);
}

}  // namespace boxplus::app
