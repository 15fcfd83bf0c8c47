// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/file_fields.h"

#include <fmt/format.h>

#include <cmath>

#include "io/as_printed.h"

namespace boxplus {
namespace {

/// Reads the number of points, and then `dimension` values for each point.
Vector<double, kDynamic> read_points(FieldReader& in, int dimension) {
  const FieldPlace place = in.place();
  const std::int64_t count = in.integer("the number of points");
  constexpr std::int64_t kMost = 1'000'000;
  if (count < 1 || count > kMost)
    in.fail(place, fmt::format("expected a number of points from 1 to {}, got {}", kMost, count));
  std::vector<double> values;  // grows while values are read, because the count may be wrong
  for (std::int64_t i = 0; i < count * dimension; ++i) values.push_back(in.number("a coordinate"));
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void write_points(const Vector<double, kDynamic>& points, int dimension, FieldWriter& out) {
  out.integer(points.size() / dimension);
  for (double value : points) out.number(value);
}

/// Whether a vector has a direction: its squared length is neither zero nor infinite.
bool is_direction(const Vector3& v) {
  return v.squaredNorm() > 1e-200 && v.squaredNorm() < 1e200;
}

}  // namespace

SE2 FileFields<SE2>::read(FieldReader& in) {
  const double x = in.number("x"), y = in.number("y");
  return {x, y, in.number("the heading θ")};
}

void FileFields<SE2>::write(const SE2& x, FieldWriter& out) {
  out.number(x.x());
  out.number(x.y());
  out.number(as_printed(x.theta()));
}

SE3 FileFields<SE3>::read(FieldReader& in) {
  Vector3 t;
  in.numbers(t.data(), 3, "a coordinate");
  const FieldPlace place = in.place();
  double q[4];
  in.numbers(q, 4, "a quaternion (qx qy qz qw)");
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(std::abs(norm - 1) <= kNormTolerance)) {
    in.fail(place, fmt::format("expected a quaternion of length 1 (± {}), got one of length {}",
                               kNormTolerance, norm));
  }
  const detail::Quaternion<double> as_read{q[0], q[1], q[2], q[3]};
  if (std::abs(norm - 1) <= kRounding) return SE3::from_unit(t, as_read);
  in.note(fmt::format("a quaternion of length {:.6g} was normalized", norm));
  return SE3(t, as_read);
}

void FileFields<SE3>::write(const SE3& x, FieldWriter& out) {
  for (int i = 0; i < 7; ++i) out.number(x.data()[i]);
}

void write_measurement(const SE3& z, FieldWriter& out) {
  for (int i = 0; i < 3; ++i) out.number(z.translation()[i]);
  const detail::Quaternion<double> q = as_printed(z.quaternion(), 0.5 * FileFields<SE3>::kNormTolerance);
  for (const double value : {q.x, q.y, q.z, q.w}) out.number(value);
}

DifferentialDrive FileFields<DifferentialDrive>::read(FieldReader& in) {
  const double left = in.number("the factor of the left wheel"),
               right = in.number("the factor of the right wheel");
  return {left, right, in.number("the baseline")};
}

void FileFields<DifferentialDrive>::write(const DifferentialDrive& x, FieldWriter& out) {
  out.number(x.left_factor);
  out.number(x.right_factor);
  out.number(x.baseline);
}

WheelSpeeds FileFields<WheelSpeeds>::read(FieldReader& in) {
  const double left = in.number("the left wheel's speed"), right = in.number("the right wheel's speed");
  return {left, right, in.number("the duration")};
}

void FileFields<WheelSpeeds>::write(const WheelSpeeds& x, FieldWriter& out) {
  out.number(x.left);
  out.number(x.right);
  out.number(x.duration);
}

PointsObservation2 EdgeFields<PointsObservation2>::read(FieldReader& in) {
  return PointsObservation2(read_points(in, 2));
}
void EdgeFields<PointsObservation2>::write(const PointsObservation2& edge, FieldWriter& out) {
  write_points(edge.measurement, 2, out);
}
PointsObservation3 EdgeFields<PointsObservation3>::read(FieldReader& in) {
  return PointsObservation3(read_points(in, 3));
}
void EdgeFields<PointsObservation3>::write(const PointsObservation3& edge, FieldWriter& out) {
  write_points(edge.measurement, 3, out);
}

Segment2 FileFields<Segment2>::read(FieldReader& in) {
  Vector<double, 4> ends;
  in.numbers(ends.data(), 4, "a coordinate");
  return {ends.head<2>(), ends.tail<2>()};
}

void FileFields<Segment2>::write(const Segment2& x, FieldWriter& out) {
  for (const Vector2& end : {x.first, x.second}) {
    out.number(end[0]);
    out.number(end[1]);
  }
}

Line2 FileFields<Line2>::read(FieldReader& in) {
  const double angle = in.number("the angle θ of the normal"), distance = in.number("the distance ρ");
  const std::int64_t first = in.integer("the id of a point, or -1");
  return {angle, distance, {first, in.integer("the id of a point, or -1")}};
}

void FileFields<Line2>::write(const Line2& x, FieldWriter& out) {
  out.number(as_printed(x.angle));
  out.number(x.distance);
  for (const std::int64_t end : x.ends) out.integer(end);
}

Plane3 FileFields<Plane3>::read(FieldReader& in) {
  Plane3 x;
  const FieldPlace place = in.place();
  in.numbers(x.coefficients.data(), 4, "a coefficient of the plane");
  if (!is_direction(x.normal())) in.fail(place, "expected a normal whose length is neither zero nor huge");
  in.numbers(x.color.data(), 3, "a color (red green blue)");
  return x;
}

void FileFields<Plane3>::write(const Plane3& x, FieldWriter& out) {
  for (const double value : x.coefficients) out.number(value);
  for (const double value : x.color) out.number(value);
}

Line3 FileFields<Line3>::read(FieldReader& in) {
  Line3 x;
  const FieldPlace moment = in.place();
  in.numbers(x.moment.data(), 3, "a coordinate of the moment");
  const FieldPlace direction = in.place();
  in.numbers(x.direction.data(), 3, "a coordinate of the direction");
  if (!is_direction(x.direction))
    in.fail(direction, "expected a direction whose length is neither zero nor huge");
  const Vector3 d = x.direction.normalized();
  const double along = x.moment.dot(d), scale = x.moment.norm() + x.direction.norm();
  if (!(std::abs(along) <= kTolerance * scale)) {
    in.fail(moment,
            fmt::format("expected a moment that is orthogonal to the direction, got one with a part of "
                        "length {} along it",
                        along));
  }
  if (std::abs(along) <= kRounding * scale) return x;
  in.note("a moment was made orthogonal to the direction of its line");
  x.moment -= along * d;
  return x;
}

void FileFields<Line3>::write(const Line3& x, FieldWriter& out) {
  for (const double value : x.moment) out.number(value);
  for (const double value : x.direction) out.number(value);
}

SegmentEndObservation2 EdgeFields<SegmentEndObservation2>::read(FieldReader& in) {
  const FieldPlace place = in.place();
  const std::int64_t end = in.integer("the number of the end point (0 or 1)");
  if (end != 0 && end != 1) in.fail(place, fmt::format("expected 0 or 1, got {}", end));
  Vector3 z;
  in.numbers(z.data(), 3, "a number");
  return {z, end == 1};
}

void EdgeFields<SegmentEndObservation2>::write(const SegmentEndObservation2& edge, FieldWriter& out) {
  out.integer(edge.is_second ? 1 : 0);
  for (int i = 0; i < 3; ++i) out.number(edge.measurement[i]);
}

}  // namespace boxplus
