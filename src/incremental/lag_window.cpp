// SPDX-License-Identifier: BSD-3-Clause
#include "incremental/lag_window.h"

#include <iterator>

namespace boxplus {

void LagWindow::set_time(VertexRef vertex, double seconds) {
  const auto [entry, is_new] = time_of_.try_emplace(vertex);
  if (!is_new) by_time_.erase(entry->second);
  entry->second = {seconds, ++calls_};
  by_time_.emplace(entry->second, vertex);
}

void LagWindow::add(const Graph& graph, VertexRef vertex) {
  detail::Frame frame;
  const bool is_pose = graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame) && frame.has_rotation;
  if (!is_pose || contains(vertex)) return;
  set_time(vertex, by_time_.empty() ? 0 : by_time_.rbegin()->first.first);
}

std::vector<VertexRef> LagWindow::take_leaving(const Graph& graph, std::size_t count, double seconds) {
  std::vector<VertexRef> leaving;
  for (auto entry = by_time_.begin(); entry != by_time_.end();) {
    const bool exists = graph.contains(entry->second);
    if (!exists) time_of_.erase(entry->second);
    entry = exists ? std::next(entry) : by_time_.erase(entry);
  }
  while (!by_time_.empty()) {
    const auto oldest = by_time_.begin();
    const bool is_old = oldest->first.first < by_time_.rbegin()->first.first - seconds;
    if (!is_old && by_time_.size() <= count) break;
    leaving.push_back(oldest->second);
    time_of_.erase(oldest->second);
    by_time_.erase(oldest);
  }
  return leaving;
}

}  // namespace boxplus
