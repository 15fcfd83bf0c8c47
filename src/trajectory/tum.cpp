// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/tum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxplus/base/error.h"
#include "boxplus/io/field_reader.h"
#include "boxplus/io/file_format.h"
#include "boxplus/manifold/quaternion.h"
#include "io/without_place.h"

namespace boxplus {
namespace {

/// The limits for the norm of a quaternion. A norm outside of these limits means that the file is wrong,
/// because rounding errors are much smaller.
constexpr double kShortest = 0.5, kLongest = 2;

detail::Quaternion<double> read_quaternion(FieldReader& in) {
  const FieldPlace place = in.place();
  detail::Quaternion<double> q;
  q.x = in.number("qx");
  q.y = in.number("qy");
  q.z = in.number("qz");
  q.w = in.number("qw");
  const double norm = std::sqrt(q.squared_norm());
  if (!(norm >= kShortest && norm <= kLongest))
    in.fail(place, fmt::format("expected a quaternion of length 1, got length {:g}", norm));
  return q;
}

TrajectoryPose read_pose(FieldReader& in) {
  TrajectoryPose pose;
  pose.time = in.number("the time");
  pose.position[0] = in.number("x");
  pose.position[1] = in.number("y");
  pose.position[2] = in.number("z");
  pose.rotation = detail::rotation_matrix(detail::normalized(read_quaternion(in)));
  in.expect_end();
  pose.id = in.line_number();
  return pose;
}

std::string_view without_carriage_return(std::string_view line) {
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

void sort_by_time(std::vector<TrajectoryPose>& poses, const std::string& name) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const TrajectoryPose& a, const TrajectoryPose& b) { return a.time < b.time; });
  const auto twice =
      std::adjacent_find(poses.begin(), poses.end(),
                         [](const TrajectoryPose& a, const TrajectoryPose& b) { return a.time == b.time; });
  if (twice == poses.end()) return;
  throw InputError(
      name, (twice + 1)->id, 1,
      fmt::format("expected a time that differs from the time of line {}, got {}", twice->id, twice->time));
}

struct FirstLine {
  std::string_view text = {};  ///< without the blanks before it
  std::int64_t number = 0;
};

/// The first line that is neither blank nor a comment, or no text.
FirstLine first_line(std::string_view text) {
  FirstLine line;
  while (!text.empty()) {
    ++line.number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    line.text = without_carriage_return(text.substr(0, end));
    const std::size_t begin = line.text.find_first_not_of(" \t\r");
    if (begin != std::string_view::npos && line.text[begin] != '#') {
      line.text.remove_prefix(begin);
      return line;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

/// Whether no file format other than .g2o, which any text could be, recognizes the text.
bool may_be_trajectory(std::string_view text) {
  return default_formats().recognize(text) == &default_formats().all().front();
}

}  // namespace

bool is_tum(std::string_view text) {
  if (!may_be_trajectory(text)) return false;
  const FirstLine first = first_line(text);
  return !first.text.empty() &&
         std::string_view("+-.0123456789").find(first.text[0]) != std::string_view::npos;
}

void refuse_tum(std::string_view text, const std::string& name) {
  if (is_tum(text))
    throw FileError(name + ": expected a graph (poses with ids), got a TUM file (poses with timestamps)");
}

void refuse_other_trajectory(std::string_view text, const std::string& name) {
  constexpr int kKittiFields = 12;
  const FirstLine first = first_line(text);
  if (first.text.empty() || !may_be_trajectory(text)) return;
  FieldReader in(name, first.number, first.text);
  const auto expected = [&](const char* got) {
    in.fail({},
            fmt::format("expected a TUM file, with lines of the form 'time x y z qx qy qz qw', got {}", got));
  };
  if (in.token("a field").find(',') != std::string_view::npos)
    expected("values with commas (in EuRoC's CSV files, times are in nanoseconds, and qw is before qx)");
  int fields = 1;
  for (; !in.at_end(); ++fields) in.token("a field");
  if (fields == kKittiFields && is_tum(text))
    expected("12 numbers (KITTI's files have matrices without times)");
}

Trajectory parse_tum(std::string_view text, const std::string& name, std::vector<GraphFile::Note>* skipped) {
  Trajectory trajectory{.source = TrajectorySource::kTum};
  std::int64_t line_number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    FieldReader in(name, ++line_number, without_carriage_return(text.substr(0, end)));
    try {
      if (!in.at_end()) trajectory.poses.push_back(read_pose(in));
    } catch (const InputError& error) {
      if (skipped == nullptr) throw;
      skipped->push_back({line_number, without_place(error, name), error.column(), true});
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  sort_by_time(trajectory.poses, name);
  require_bounded(trajectory, name);
  return trajectory;
}

}  // namespace boxplus
