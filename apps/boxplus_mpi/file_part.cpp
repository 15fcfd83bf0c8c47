// SPDX-License-Identifier: BSD-3-Clause
#include "file_part.h"

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/disjoint_sets.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/text_source.h"
#include "divide_graph.h"
#include "io/bal/bal_format.h"

namespace boxplus::app {
namespace {

bool is_bal(const TextSource& text) {
  if (text.block_count() == 0) return false;
  std::string memory;
  const FileFormat* format = default_formats().recognize(text.block(0, memory));
  return format != nullptr && format->name == bal_format().name;
}

/// Enough points to see which cameras are connected: at most two per camera.
std::vector<bool> connecting_points(const BalObservations& observations) {
  std::vector<bool> is_connecting(observations.points, false), is_seen(observations.cameras, false);
  std::vector<std::uint32_t> first_camera(observations.points, observations.cameras);
  DisjointSets sets(observations.cameras);
  for (const std::uint64_t pair : observations.pairs) {
    const auto point = static_cast<std::uint32_t>(pair >> 32), camera = static_cast<std::uint32_t>(pair);
    if (first_camera[point] == observations.cameras) first_camera[point] = camera;
    if (sets.join(first_camera[point], camera) || !is_seen[camera]) is_connecting[point] = true;
    is_seen[camera] = true;
  }
  return is_connecting;
}

/// The observations of each point.
std::vector<std::uint32_t> degrees(const BalObservations& observations) {
  std::vector<std::uint32_t> degree(observations.points, 0);
  for (const std::uint64_t pair : observations.pairs) ++degree[pair >> 32];
  return degree;
}

struct Choice {
  std::vector<bool> own;
  BalPoints read;  ///< these, and those that connect cameras
};

Choice choose_points(BalObservations observations, std::uint32_t part, int parts) {
  Choice choice{std::vector<bool>(observations.points), {.is_wanted = connecting_points(observations)}};
  const std::vector<std::uint32_t> degree = degrees(observations);
  const std::vector<std::uint32_t> part_of =
      mpi::parts_of_eliminated(observations.pairs, observations.points, observations.cameras, parts);
  for (std::size_t point = 0; point < part_of.size(); ++point) {
    choice.own[point] = part_of[point] == part;
    if (choice.own[point]) choice.read.is_wanted[point] = true;
    if (choice.read.is_wanted[point]) choice.read.observations += degree[point];
  }
  return choice;
}

}  // namespace

std::optional<FilePart> read_part(const std::string& path, const ReadOptions& options, int part, int parts) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return std::nullopt;
  const TextSource text = TextSource::of_file(path);
  if (!is_bal(text)) return std::nullopt;
  FilePart result;
  std::uint32_t cameras = 0;
  Choice choice;
  {
    BalObservations observations = read_bal_observations(text, options);
    if (observations.pairs.empty()) return std::nullopt;
    cameras = observations.cameras;
    result.all_edges = observations.pairs.size();
    choice = choose_points(std::move(observations), static_cast<std::uint32_t>(part), parts);
  }
  result.file = read_bal_part(text, options, choice.read);
  result.file.format = bal_format().name;
  const Graph& graph = result.file.graph;
  std::erase_if(result.file.edges, [&](const EdgeRef& edge) {
    const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
    const detail::VertexPool& points = *graph.vertex_pools()[pool.vertex_pool(edge.slot, 1)];
    const Id point = points.id(pool.vertex_slots(edge.slot)[1]) - Id{cameras};
    if (choice.own[static_cast<std::size_t>(point)]) return false;
    result.others.push_back(edge);
    return true;
  });
  return result;
}

}  // namespace boxplus::app
