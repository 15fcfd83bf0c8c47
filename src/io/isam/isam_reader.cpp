// SPDX-License-Identifier: BSD-3-Clause
#include "io/isam/isam_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "boxplus/io/information_fields.h"
#include "io/line_reader.h"
#include "io/toro/euler_pose.h"

namespace boxplus {
namespace {

using Measurement = IsamMeasurements::One;
using Value = IsamMeasurements::Value;

/// Replaces the upper triangle of R by that of Ω = (R D)ᵀ(R D), for a diagonal matrix D.
template <int kRows, class Scale>
void square(std::span<double> values, Scale&& scale_of) {
  std::array<std::array<double, kRows>, kRows> R{};
  auto value = values.begin();
  for (std::size_t i = 0; i < kRows; ++i) {
    for (std::size_t j = i; j < kRows; ++j) R[i][j] = *value++ * scale_of(static_cast<int>(j));
  }
  value = values.begin();
  for (std::size_t i = 0; i < kRows; ++i) {
    for (std::size_t j = i; j < kRows; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k <= i; ++k) sum += R[k][i] * R[k][j];
      *value++ = sum;
    }
  }
}

template <int kRows>
void square_of_rows(std::span<double> values) {
  if constexpr (kRows == 6) {
    square<kRows>(values, euler_row_scale);
  } else {
    square<kRows>(values, [](int) { return 1; });
  }
}

/// Reads R, the rest of a line.
template <int kRows>
Information read_square_root(FieldReader& in) {
  const FieldPlace place = in.place();
  const detail::UncheckedInformation information =
      detail::read_unchecked_information(in, kRows, &square_of_rows<kRows>);
  information.check(in);
  const std::span<const double> values = information.value.values();
  if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0; }))
    in.fail(place, "information: expected a square root R with a nonzero RᵀR, got one whose RᵀR is zero");
  in.expect_end();
  return information.value;
}

Measurement read_motion(FieldReader& in) {
  std::array<double, 3> z{};
  in.numbers(z.data(), 3, "a coordinate of the motion");
  return {0, 0, SE2(z[0], z[1], z[2]), read_square_root<3>(in)};
}

Measurement read_motion3(FieldReader& in) {
  const SE3 z = read_euler_pose(in);
  return {0, 0, z, read_square_root<6>(in)};
}

template <class Point>
Measurement read_point(FieldReader& in) {
  constexpr int kRows = Point::RowsAtCompileTime;
  Point z;
  in.numbers(z.data(), kRows, "a coordinate of the landmark");
  return {0, 0, z, read_square_root<kRows>(in)};
}

struct LineType {
  std::string_view tag;
  Measurement (*read)(FieldReader&);
  std::size_t from, to;  ///< index of the types of both ends in Value
  const char* of_to;     ///< what `to` is, for messages

  bool is_to_landmark() const { return to >= 2; }
};

constexpr std::array<LineType, 6> kLineTypes{{{"ODOMETRY", read_motion, 0, 0, "a pose"},
                                              {"EDGE2", read_motion, 0, 0, "a pose"},
                                              {"LANDMARK", read_point<Vector2>, 0, 2, "a landmark"},
                                              {"ODOMETRY3", read_motion3, 1, 1, "a pose"},
                                              {"EDGE3", read_motion3, 1, 1, "a pose"},
                                              {"POINT3", read_point<Vector3>, 1, 3, "a landmark"}}};

class IsamReader {
 public:
  IsamMeasurements read(const TextSource& text, const ReadOptions& options, GraphFile& file) {
    read_lines(text, options, file,
               [this](std::string_view tag, FieldReader& in, std::string_view) { take(tag, in); });
    others_.append_note(file.notes);
    return std::move(result_);
  }

 private:
  void take(std::string_view tag, FieldReader& in) {
    const auto type = std::find_if(kLineTypes.begin(), kLineTypes.end(),
                                   [&](const LineType& each) { return each.tag == tag; });
    if (type == kLineTypes.end()) return others_.add(tag);
    IsamMeasurements::Types& ends = type->is_to_landmark() ? result_.landmarks : result_.poses;
    const Id from = read_id(in, "a pose", result_.poses, type->from);
    const FieldPlace place = in.place();
    const Id to = read_id(in, type->of_to, ends, type->to);
    if (!type->is_to_landmark() && from == to)
      in.fail(place, fmt::format("expected the id of another pose, but pose {} appears twice", from));
    Measurement measurement = type->read(in);
    measurement.from = from;
    measurement.to = to;
    result_.poses.emplace(from, type->from);
    ends.emplace(to, type->to);
    result_.all.push_back(std::move(measurement));
  }

  static Id read_id(FieldReader& in, const char* what, const IsamMeasurements::Types& known,
                    std::size_t type) {
    const FieldPlace place = in.place();
    const Id id = in.integer(fmt::format("the id of {}", what));
    if (id < 0 || id > kLargestIsamId)
      in.fail(place, fmt::format("expected the id of {} (an integer from 0 to {}), got {}", what,
                                 kLargestIsamId, id));
    const auto found = known.find(id);
    if (found != known.end() && found->second != type) {
      const auto space = [](std::size_t each) { return each % 2 == 0 ? "in the plane" : "in space"; };
      in.fail(place, fmt::format("expected the id of {} {}, but a line before it has {} {}", what,
                                 space(type), id, space(found->second)));
    }
    return id;
  }

  IsamMeasurements result_;
  OtherLines others_;
};

}  // namespace

IsamMeasurements read_isam(const TextSource& text, const ReadOptions& options, GraphFile& file) {
  return IsamReader().read(text, options, file);
}

}  // namespace boxplus
