// SPDX-License-Identifier: BSD-3-Clause
#include "io/carmen/carmen_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "boxplus/graph/information.h"
#include "boxplus/io/data.h"
#include "boxplus/types/between.h"
#include "io/data_fields.h"
#include "io/g2o/notes.h"
#include "io/line_reader.h"

namespace boxplus {
namespace {

constexpr std::string_view kOdometry = "ODOM", kFrontLaser = "FLASER", kRearLaser = "RLASER";

/// ROBOTLASER2 to ROBOTLASER5: the other lasers of the robot, with the fields of ROBOTLASER1.
bool is_other_laser(std::string_view tag) {
  constexpr std::string_view kName = RobotLaser::kTag.substr(0, RobotLaser::kTag.size() - 1);
  return tag.size() == RobotLaser::kTag.size() && tag.starts_with(kName) && tag.back() >= '2' &&
         tag.back() <= '5';
}

/// Ranges of a SICK LMS 200 from here on (8183 to 8191 cm) are codes of failures.
constexpr double kAssumedMaxRange = 81.83;

/// Builds a GraphFile from the messages of a log, in their order.
class CarmenReader {
 public:
  CarmenReader(const TextSource& text, const ReadOptions& options) : text_(text), options_(options) {}

  GraphFile read() {
    read_lines(text_, options_, file_,
               [this](std::string_view tag, FieldReader& in, std::string_view line) { take(tag, in, line); });
    add_notes();
    return std::move(file_);
  }

 private:
  using Pose = std::array<double, 3>;

  void take(std::string_view tag, FieldReader& in, std::string_view line) {
    if (tag == kOdometry) {
      take_odometry(in);
    } else if (tag == kFrontLaser || tag == kRearLaser) {
      take_laser(in);
    } else if (tag == RobotLaser::kTag || is_other_laser(tag)) {
      const FieldPlace begin = in.place();
      const RobotLaser laser = RobotLaser::read(in);
      move_to(laser.robot_pose, begin, in);
      keep(tag == RobotLaser::kTag ? std::string(line) : format_data(laser));
    } else if (tag == RawLaser::kTag) {
      RawLaser::read(in);
      keep(line);
    } else {
      others_.add(tag);
    }
  }

  void take_odometry(FieldReader& in) {
    Pose pose{};
    const FieldPlace begin = in.place();
    in.numbers(pose.data(), 3, "the pose of the robot");
    for (const char* what : {"a translational velocity", "a rotational velocity", "an acceleration"})
      in.number(what);
    RobotStamp::read(in);
    in.expect_end();
    move_to(pose, begin, in);
  }

  /// Reads FLASER or RLASER. Keeps it as ROBOTLASER1, which also has the directions of the beams.
  void take_laser(FieldReader& in) {
    RobotLaser laser;
    laser.ranges = read_list(in, "the number of ranges", "a range");
    in.numbers(laser.laser_pose.data(), 3, "the pose of the laser");
    const FieldPlace begin = in.place();
    in.numbers(laser.robot_pose.data(), 3, "the pose of the robot");
    laser.stamp = RobotStamp::read(in);
    in.expect_end();
    const AssumedBeams beams = assumed_beams(laser.ranges.size());
    laser.first_beam = beams.first;
    laser.field_of_view = beams.field_of_view;
    laser.angular_step = beams.step;
    laser.max_range = kAssumedMaxRange;
    move_to(laser.robot_pose, begin, in);
    keep(format_data(laser));
    ++assumed_scans_;
  }

  /// Continues at a pose of the odometry. `place` is a place of its line, for errors.
  void move_to(const Pose& pose, FieldPlace place, const FieldReader& in) {
    if (last_ && pose == pose_) return;
    constexpr double kMostDistant = 1e150;
    if (!(std::max(std::abs(pose[0]), std::abs(pose[1])) < kMostDistant)) {
      in.fail(place, fmt::format("expected a position of the robot within {} m, got ({}, {})", kMostDistant,
                                 pose[0], pose[1]));
    }
    const SE2 T_odometry_robot(pose[0], pose[1], pose[2]);
    const auto vertex = file_.graph.add_vertex(T_odometry_robot);
    if (last_) {
      const SE2 motion = file_.graph.estimate(*last_).inverse_times(T_odometry_robot);
      const SE2 listed(motion.x(), motion.y(), motion.theta());  // the same bits as if a file listed it
      file_.edges.push_back(
          file_.graph.add_edge(Between(listed), odometry_information(listed), *last_, vertex));
    }
    last_ = vertex;
    pose_ = pose;
  }

  /// Keeps a line of data after the vertex of the last pose.
  void keep(std::string_view line) {
    while (line.ends_with('\r')) line.remove_suffix(1);
    using Place = GraphFile::KeptLine::Place;
    file_.kept.push_back({last_ ? Place::kAfterVertex : Place::kBegin, last_ ? file_.graph.id(*last_) : 0,
                          std::string(line), file_.lines});
  }

  void add_notes() {
    others_.append_note(file_.notes);
    if (!file_.edges.empty()) {
      const auto count = static_cast<std::int64_t>(file_.edges.size());
      file_.notes.push_back(
          {0, fmt::format("a log of CARMEN has no covariances: they are assumed for {} of the odometry",
                          counted(count, "edge", "edges"))});
    }
    if (assumed_scans_ > 0) {
      file_.notes.push_back(
          {0, fmt::format("{} without the directions of the beams: they and the maximum range are assumed",
                          counted(assumed_scans_, "scan", "scans"))});
    }
  }

  const TextSource& text_;
  const ReadOptions& options_;
  GraphFile file_;
  OtherLines others_;
  std::optional<VertexHandle<SE2>> last_;
  Pose pose_{};  // of the vertex last_, as it is in the log
  std::int64_t assumed_scans_ = 0;
};

/// Scans occur in .g2o files, too. So the first other message decides, if there is one.
bool is_log(std::string_view text) {
  constexpr std::array<std::string_view, 13> kMessages{
      kOdometry, kFrontLaser, kRearLaser, "PARAM",     "SYNC",    "TRUEPOS", "LASER3",
      "LASER4",  "SONAR",     "BUMPER",   "RAWLASER2", "NMEAGGA", "NMEARMC"};
  bool has_pose = false;
  const std::string_view tag = first_tag(text, [&](std::string_view each) {
    has_pose = has_pose || each == RobotLaser::kTag;
    return each == RobotLaser::kTag || each == RawLaser::kTag;
  });
  if (tag.empty()) return has_pose;
  return is_other_laser(tag) || std::find(kMessages.begin(), kMessages.end(), tag) != kMessages.end();
}

}  // namespace

Information odometry_information(const SE2& motion) {
  const double distance = std::hypot(motion.x(), motion.y()), angle = std::abs(motion.theta());
  const double position = 0.01 + 0.05 * distance, heading = 0.005 + 0.05 * angle + 0.02 * distance;
  const double weight = 1 / (position * position);
  return Information::diagonal(std::array{weight, weight, 1 / (heading * heading)});
}

AssumedBeams assumed_beams(std::size_t count) {
  constexpr double kDegree = std::numbers::pi / 180;
  if (count == 0) return {};
  const double field_of_view = (count == 101 || count == 201 || count == 401 ? 100 : 180) * kDegree;
  const std::size_t steps = count == 1 ? 1 : count - count % 2;
  return {-field_of_view / 2, field_of_view, field_of_view / static_cast<double>(steps)};
}

FileFormat carmen_format() {
  return {.name = "CARMEN",
          .extension = ".clf",
          .recognize = is_log,
          .read = [](const TextSource& text, const ReadOptions& options) {
            return CarmenReader(text, options).read();
          }};
}

}  // namespace boxplus
