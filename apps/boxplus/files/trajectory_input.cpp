// SPDX-License-Identifier: BSD-3-Clause
#include "files/trajectory_input.h"

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
  return is_tum(text) ? parse_tum(text, name) : trajectory_of(parse_with_notes(text, path, reading), name);
}

GraphFile read_truth(const std::string& path, const ReadOptions& reading) {
  const std::string text = read_text(path);
  refuse_tum(text, input_name(path));
  return parse_with_notes(text, path, reading);
}

}  // namespace boxplus::app
