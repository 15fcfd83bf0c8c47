// SPDX-License-Identifier: BSD-3-Clause
#include "file_part.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "boxplus/io/file_format.h"
#include "boxplus/io/text_source.h"
#include "choose_points.h"
#include "io/bal/bal_format.h"
#include "io/colmap/colmap_format.h"
#include "io/model/model_graph.h"

namespace boxplus::app {
namespace {

bool is_bal(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  const TextSource text = TextSource::of_file(path);
  if (text.block_count() == 0) return false;
  std::string memory;
  const FileFormat* format = default_formats().recognize(text.block(0, memory));
  return format != nullptr && format->name == bal_format().name;
}

/// Divides the edges of a graph that has the points of a process and others.
void find_others(FilePart& part, const std::function<bool(Id)>& is_own) {
  const Graph& graph = part.file.graph;
  std::erase_if(part.file.edges, [&](const EdgeRef& edge) {
    const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
    const detail::VertexPool& points = *graph.vertex_pools()[pool.vertex_pool(edge.slot, 1)];
    if (is_own(points.id(pool.vertex_slots(edge.slot)[1]))) return false;
    part.others.push_back(edge);
    return true;
  });
}

std::optional<FilePart> bal_part(const std::string& path, const ReadOptions& options, std::uint32_t part,
                                 int parts) {
  const TextSource text = TextSource::of_file(path);
  FilePart result;
  std::uint32_t cameras = 0;
  PointChoice choice;
  {
    BalObservations observations = read_bal_observations(text, options);
    if (observations.pairs.empty()) return std::nullopt;
    cameras = observations.cameras;
    result.all_edges = observations.pairs.size();
    choice = choose_points(std::move(observations), part, parts);
  }
  result.file = read_bal_part(text, options, choice.read);
  find_others(result, [&](Id id) { return choice.own[static_cast<std::size_t>(id - Id{cameras})]; });
  return result;
}

/// The points of a model by their ids.
using PointNumbers = std::unordered_map<std::uint64_t, std::uint32_t>;

/// Who observes whom. Images have numbers in the order of their ids.
BalObservations observations_of(const SparseModel& model, const PointNumbers& points) {
  std::vector<const SparseModel::Image*> images;
  for (const SparseModel::Image& image : model.images) images.push_back(&image);
  std::ranges::sort(images, {}, &SparseModel::Image::id);
  BalObservations result{
      static_cast<std::uint32_t>(images.size()), static_cast<std::uint32_t>(points.size()), {}};
  for (std::size_t image = 0; image < images.size(); ++image) {
    for (const SparseModel::Feature& feature : images[image]->features) {
      if (feature.point != SparseModel::Feature::kNoPoint)
        result.pairs.push_back((std::uint64_t{points.at(feature.point)} << 32) + image);
    }
  }
  return result;
}

/// Leaves out other points, and 2-D points that do not show one of these.
void reduce(SparseModel& model, const PointNumbers& numbers, const std::vector<bool>& is_wanted) {
  const auto is_left_out = [&](std::uint64_t point) {
    return point == SparseModel::Feature::kNoPoint || !is_wanted[numbers.at(point)];
  };
  std::erase_if(model.points, [&](const SparseModel::Point& point) { return is_left_out(point.id); });
  model.points.shrink_to_fit();
  std::unordered_map<std::uint64_t, SparseModel::Point*> points;
  for (SparseModel::Point& point : model.points) {
    point.track.clear();
    points[point.id] = &point;
  }
  for (SparseModel::Image& image : model.images) {
    std::erase_if(image.features,
                  [&](const SparseModel::Feature& feature) { return is_left_out(feature.point); });
    image.features.shrink_to_fit();
    for (std::size_t i = 0; i < image.features.size(); ++i)
      points.at(image.features[i].point)->track.push_back({image.id, static_cast<std::uint32_t>(i)});
  }
}

std::optional<FilePart> colmap_part(const std::string& path, std::uint32_t part, int parts) {
  SparseModel model = read_colmap(path);
  PointNumbers numbers;
  for (const SparseModel::Point& point : model.points)
    numbers.emplace(point.id, static_cast<std::uint32_t>(numbers.size()));
  BalObservations observations = observations_of(model, numbers);
  if (observations.pairs.empty()) return std::nullopt;
  FilePart result;
  result.all_edges = observations.pairs.size();
  const PointChoice choice = choose_points(std::move(observations), part, parts);
  std::vector<std::string> notes = unusual_parts(model);
  reduce(model, numbers, choice.read.is_wanted);
  const Id first = model.first_point_vertex();
  result.file = graph_of(std::move(model));
  for (std::string& text : notes) result.file.notes.push_back({0, std::move(text)});
  find_others(result, [&](Id id) { return choice.own[numbers.at(static_cast<std::uint64_t>(id - first))]; });
  return result;
}

}  // namespace

std::optional<FilePart> read_part(const std::string& path, const ReadOptions& options, int part, int parts) {
  const FileFormat* const folder = default_formats().recognize_folder(path);
  const bool is_colmap = folder != nullptr &&
                         (folder->name == colmap_format().name || folder->name == colmap_text_format().name);
  if (!is_colmap && !is_bal(path)) return std::nullopt;
  const auto rank = static_cast<std::uint32_t>(part);
  std::optional<FilePart> result =
      is_colmap ? colmap_part(path, rank, parts) : bal_part(path, options, rank, parts);
  if (result) result->file.format = is_colmap ? folder->name : bal_format().name;
  return result;
}

}  // namespace boxplus::app
