// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "boxplus/base/error.h"
#include "boxplus/graph/make_room.h"
#include "io/bal/bal_format.h"
#include "io/bal/bal_pose.h"
#include "io/bal/number_block.h"
#include "io/characters.h"
#include "io/moderate_pose.h"
#include "io/pipeline.h"

namespace boxplus {
namespace {

constexpr std::array<const char*, 3> kCountNames{"the number of cameras", "the number of points",
                                                 "the number of observations"};
constexpr std::array<const char*, 4> kObservationNames{"the index of a camera", "the index of a point",
                                                       "the x coordinate of a pixel",
                                                       "the y coordinate of a pixel"};

/// "1 point has", "3 points have".
std::string counted_with_verb(std::int64_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// Builds a GraphFile. All workers split blocks into numbers. One of them takes the numbers of the finished
/// blocks in the order of the file, and collects those of one item: the counts, an observation, a camera or a
/// point.
class BalReader {
 public:
  BalReader(const TextSource& text, const ReadOptions& options) : text_(text), options_(options) {}

  /// Makes no graph.
  void visit(const BalVisitor& visitor) {
    visitor_ = &visitor;
    (void)read();
  }

  /// Leaves out all edges.
  GraphFile read_vertices() {
    makes_edges_ = false;
    return read();
  }

  /// Leaves out other points.
  GraphFile read_part(const BalPoints& wanted) {
    wanted_ = &wanted;
    return read();
  }

  GraphFile read() {
    prepare_and_consume<NumberBlock>(
        text_.block_count(), options_.threads,
        [&](std::size_t k, NumberBlock& block) { block.read(text_, k); },
        [&](const NumberBlock& block) { take(block); });
    if (part_ != Part::kEnd)
      throw InputError(text_.name(), file_.lines + 1, 1,
                       fmt::format("expected {}, got the end of the file", expected_field()));
    add_notes();
    return std::move(file_);
  }

 private:
  enum class Part : std::uint8_t { kCounts, kObservations, kCameras, kPoints, kEnd };

  void take(const NumberBlock& block) {
    const std::vector<double>& values = block.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (part_ == Part::kEnd) refuse(block, i);
      if (wants_integer() && !is_index(block, i)) refuse(block, i);
      item_[count_++] = values[i];
      if (count_ < item_size()) continue;
      count_ = 0;
      finish_item(block, i);
    }
    if (block.ends_with_another_field()) refuse(block, values.size());
    file_.lines += block.line_count();
  }

  std::size_t item_size() const {
    switch (part_) {
      case Part::kCounts:
      case Part::kPoints:
        return 3;
      case Part::kObservations:
        return 4;
      default:
        return kBalCameraValues;
    }
  }

  bool wants_integer() const {
    return part_ == Part::kCounts || (part_ == Part::kObservations && count_ < 2);
  }
  /// Whether the next value is a count, or an index that exists.
  bool is_index(const NumberBlock& block, std::size_t i) const {
    const double value = block.values()[i];
    return block.is_integer(i) && value >= 0 &&
           (part_ == Part::kCounts || value < (count_ == 0 ? camera_count_ : point_count_));
  }

  /// Uses the values of a finished item, whose last value is number `last` of the block.
  void finish_item(const NumberBlock& block, std::size_t last) {
    switch (part_) {
      case Part::kCounts:
        take_counts(block, last);
        break;
      case Part::kObservations:
        take_observation();
        break;
      case Part::kCameras:
        take_camera(block, last);
        break;
      default:
        if (is_wanted(items_)) file_.graph.set_estimate(points_[items_], Vector3(item_.data()));
    }
    ++items_;
    if (part_ == Part::kCounts) items_ = 0;
    const auto is_complete = [this] {
      return items_ == (part_ == Part::kObservations ? observation_count_
                        : part_ == Part::kCameras    ? is_camera_used_.size()
                                                     : is_point_used_.size());
    };
    if (part_ == Part::kCounts) part_ = Part::kObservations;
    while (part_ != Part::kEnd && is_complete()) {
      part_ = static_cast<Part>(static_cast<int>(part_) + 1);
      items_ = 0;
    }
  }

  /// Creates the vertices, unless the text is too short for all of them.
  void take_counts(const NumberBlock& block, std::size_t last) {
    // A value takes at least one digit and one blank; after the last value, the blank may be missing.
    const double bytes = 2 * (4 * item_[2] + kBalCameraValues * item_[0] + 3 * item_[1]) - 1;
    if (bytes > static_cast<double>(text_.size())) {
      fail(block, last,
           fmt::format("expected at most as many cameras, points and observations as fit into a file of {} "
                       "bytes, got {}, {} and {}",
                       text_.size(), item_[0], item_[1], item_[2]));
    }
    camera_count_ = item_[0];
    point_count_ = item_[1];
    observation_count_ = static_cast<std::size_t>(item_[2]);
    is_camera_used_.resize(static_cast<std::size_t>(camera_count_));
    is_point_used_.resize(static_cast<std::size_t>(point_count_));
    if (visitor_) return visitor_->counts(std::span(item_).first(item_size()));
    create_vertices();
  }

  void create_vertices() {
    cameras_.reserve(is_camera_used_.size());
    points_.resize(is_point_used_.size());
    while (cameras_.size() < is_camera_used_.size()) cameras_.push_back(file_.graph.add_vertex(BalVertex()));
    for (std::size_t point = 0; point < points_.size(); ++point) {
      if (!is_wanted(point)) continue;
      points_[point] = file_.graph.add_vertex(Vector3(0, 0, 0), static_cast<Id>(cameras_.size() + point));
      file_.graph.set_eliminated(points_[point], true);
    }
    if (makes_edges_) detail::reserve(file_.edges, edge_count());
  }

  bool is_wanted(std::size_t point) const {
    return visitor_ == nullptr && (wanted_ == nullptr || wanted_->is_wanted[point]);
  }
  /// The number of observations of these points.
  std::size_t edge_count() const { return wanted_ ? wanted_->observations : observation_count_; }

  void take_observation() {
    const auto camera = static_cast<std::size_t>(item_[0]), point = static_cast<std::size_t>(item_[1]);
    is_camera_used_[camera] = true;
    is_point_used_[point] = true;
    if (visitor_) visitor_->observation(std::span(item_).first(item_size()));
    if (!makes_edges_ || !is_wanted(point)) return;
    file_.edges.push_back(
        file_.graph.add_edge(BalEdge(Vector2(item_[2], item_[3])), cameras_[camera], points_[point]));
    if (file_.edges.size() == 1) file_.graph.reserve_edges(file_.edges.back(), edge_count());
  }

  void take_camera(const NumberBlock& block, std::size_t last) {
    const SE3 T_world_camera = BalPose(Vector3(item_.data()), Vector3(item_.data() + 3)).T_world_camera();
    if (!is_moderate(T_world_camera))
      fail(block, last,
           fmt::format("camera {}: expected a pose with moderate values, got values that overflow", items_));
    if (visitor_) return;
    file_.graph.set_estimate(cameras_[items_],
                             BalVertex(T_world_camera, BalCamera(item_[6], item_[7], item_[8])));
  }

  /// A name of the next field, for messages.
  std::string expected_field() const {
    constexpr std::array kCameraNames{"rx", "ry", "rz", "tx", "ty", "tz", "f", "k1", "k2"};
    constexpr std::array kPointNames{"x", "y", "z"};
    const auto index = [](double count) {
      return count == 0 ? std::string("there are none") : fmt::format("an integer from 0 to {}", count - 1);
    };
    switch (part_) {
      case Part::kCounts:
        return fmt::format("{} (an integer of at least 0)", kCountNames[count_]);
      case Part::kObservations:
        if (count_ < 2)
          return fmt::format("{} ({})", kObservationNames[count_],
                             index(count_ == 0 ? camera_count_ : point_count_));
        return fmt::format("{} (a finite number)", kObservationNames[count_]);
      case Part::kCameras:
        return fmt::format("{} of camera {} (a finite number)", kCameraNames[count_], items_);
      case Part::kPoints:
        return fmt::format("{} of point {} (a finite number)", kPointNames[count_], items_);
      default:
        return "the end of the file";
    }
  }

  [[noreturn]] void refuse(const NumberBlock& block, std::size_t field) const {
    fail(block, field,
         fmt::format("expected {}, got {}", expected_field(), in_quotes(block.field(field).text)));
  }
  [[noreturn]] void fail(const NumberBlock& block, std::size_t field, const std::string& message) const {
    const NumberBlock::Field place = block.field(field);
    throw InputError(text_.name(), file_.lines + place.line + 1, place.column, message);
  }

  void add_notes() {
    const auto note = [this](const std::vector<bool>& used, const char* one, const char* many) {
      const auto unused = std::count(used.begin(), used.end(), false);
      if (unused > 0) file_.notes.push_back({0, counted_with_verb(unused, one, many) + " no observations"});
    };
    note(is_camera_used_, "camera has", "cameras have");
    note(is_point_used_, "point has", "points have");
  }

  const TextSource& text_;
  const ReadOptions& options_;
  const BalPoints* wanted_ = nullptr;    // null: all points
  const BalVisitor* visitor_ = nullptr;  // instead of a graph
  bool makes_edges_ = true;
  GraphFile file_;
  Part part_ = Part::kCounts;
  std::array<double, kBalCameraValues> item_{};  // the values of the current item
  std::size_t count_ = 0;                        // the number of these values
  std::size_t items_ = 0;                        // the number of finished items of this part
  double camera_count_ = 0, point_count_ = 0;  // as doubles, because the file's values are compared with them
  std::size_t observation_count_ = 0;
  std::vector<VertexHandle<BalVertex>> cameras_;
  std::vector<VertexHandle<Vector3>> points_;
  std::vector<bool> is_camera_used_, is_point_used_;
};

}  // namespace

GraphFile read_bal(const TextSource& text, const ReadOptions& options) {
  return BalReader(text, options).read();
}

void visit_bal(const TextSource& text, const ReadOptions& options, const BalVisitor& visitor) {
  BalReader(text, options).visit(visitor);
}

BalObservations read_bal_observations(const TextSource& text, const ReadOptions& options) {
  BalObservations result;
  const auto counts = [&](std::span<const double> counts) {
    result.cameras = static_cast<std::uint32_t>(counts[0]);
    result.points = static_cast<std::uint32_t>(counts[1]);
    result.pairs.reserve(static_cast<std::size_t>(counts[2]));
  };
  const auto observation = [&](std::span<const double> values) {
    const auto camera = static_cast<std::uint64_t>(values[0]), point = static_cast<std::uint64_t>(values[1]);
    result.pairs.push_back((point << 32) + camera);
  };
  visit_bal(text, options, {counts, observation});
  return result;
}

GraphFile read_bal_part(const TextSource& text, const ReadOptions& options, const BalPoints& points) {
  return BalReader(text, options).read_part(points);
}

GraphFile read_bal_vertices(const TextSource& text, const ReadOptions& options) {
  return BalReader(text, options).read_vertices();
}

}  // namespace boxplus
