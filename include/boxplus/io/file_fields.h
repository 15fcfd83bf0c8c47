// SPDX-License-Identifier: BSD-3-Clause
// The representation of values in a file: estimates of vertices and parameters, and measurements. For your
// own types, specialize FileFields:
//
//     template <> struct boxplus::FileFields<Pose> {
//       static Pose read(FieldReader& in);                     // throws InputError through `in`
//       static void write(const Pose& x, FieldWriter& out);
//     };
#pragma once

#include "boxplus/io/field_reader.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/types/slam2d/line.h"
#include "boxplus/types/slam2d/points_observation.h"
#include "boxplus/types/slam2d/segment.h"
#include "boxplus/types/slam2d/wheel_odometry.h"
#include "boxplus/types/slam3d/line.h"
#include "boxplus/types/slam3d/plane.h"
#include "boxplus/types/slam3d/points_observation.h"

namespace boxplus {

template <class T>
struct FileFields;

/// One scalar.
template <>
struct FileFields<double> {
  static double read(FieldReader& in) { return in.number("a number"); }
  static void write(double x, FieldWriter& out) { out.number(x); }
};

/// Vectors of fixed size.
template <int N>
requires(N > 0) struct FileFields<Vector<double, N>> {
  static Vector<double, N> read(FieldReader& in) {
    Vector<double, N> x;
    in.numbers(x.data(), N, "a coordinate");
    return x;
  }
  static void write(const Vector<double, N>& x, FieldWriter& out) {
    for (int i = 0; i < N; ++i) out.number(x[i]);
  }
};

/// x y θ.
template <>
struct FileFields<SE2> {
  static SE2 read(FieldReader& in);
  static void write(const SE2& x, FieldWriter& out);
};

/// x y z qx qy qz qw. The length of the quaternion must be within kNormTolerance of 1. If the length is
/// within kRounding of 1, the difference may come from rounding to few digits. The pose is then kept bit for
/// bit as it was read, so that the chi2 of the file is the same as in other programs, and the pose is written
/// with the digits that were read. Otherwise, the quaternion is normalized.
template <>
struct FileFields<SE3> {
  static constexpr double kNormTolerance = 1e-3, kRounding = 1e-5;
  static SE3 read(FieldReader& in);
  static void write(const SE3& x, FieldWriter& out);
};

/// k_left k_right baseline.
template <>
struct FileFields<DifferentialDrive> {
  static DifferentialDrive read(FieldReader& in);
  static void write(const DifferentialDrive& x, FieldWriter& out);
};

/// v_left v_right dt.
template <>
struct FileFields<WheelSpeeds> {
  static WheelSpeeds read(FieldReader& in);
  static void write(const WheelSpeeds& x, FieldWriter& out);
};

/// x1 y1 x2 y2.
template <>
struct FileFields<Segment2> {
  static Segment2 read(FieldReader& in);
  static void write(const Segment2& x, FieldWriter& out);
};

/// θ ρ, and the ids of two points or −1.
template <>
struct FileFields<Line2> {
  static Line2 read(FieldReader& in);
  static void write(const Line2& x, FieldWriter& out);
};

/// The coefficients a b c d, and the color r g b. The normal (a, b, c) may have any length but zero. Planes
/// are kept bit for bit as they were read.
template <>
struct FileFields<Plane3> {
  static Plane3 read(FieldReader& in);
  static void write(const Plane3& x, FieldWriter& out);
};

/// The moment w, and the direction d, which must not be zero. The part of w along d must not be longer than
/// kTolerance (|w| + |d|). If it is at most kRounding (|w| + |d|), it may come from rounding to few digits,
/// and the line is kept bit for bit as it was read. Otherwise, this part is removed, with a note.
template <>
struct FileFields<Line3> {
  static constexpr double kTolerance = 1e-3, kRounding = 1e-5;
  static Line3 read(FieldReader& in);
  static void write(const Line3& x, FieldWriter& out);
};

/// Writes a measured pose, which was read by FileFields<SE3> and normalized, with the fewest digits that read
/// back to the same pose.
void write_measurement(const SE3& z, FieldWriter& out);

/// The fields of an edge in a file, between the ids of its vertices and Ω. By default, these are the fields
/// of its member `measurement`. Quaternions of measurements are normalized. If files do not list Ω as its
/// upper triangle by rows (another order or scale), the specialization also has functions that convert it:
///
///     static void to_upper_triangle(std::span<double> listed);
///     static void from_upper_triangle(std::span<double> upper);
///
/// If lines have fields after Ω, it has functions for them, too:
///
///     static void read_rest(E& edge, FieldReader& in);
///     static void write_rest(const E& edge, FieldWriter& out);
///
/// If Ω is not on the lines, because it follows from the edge, it has the function
///
///     static Information information(const E& edge);
///
/// In EdgeFields and FileFields, `static constexpr int kOptionalFields` is the number of fields at the end of
/// a line that may be missing together.
template <class E>
struct EdgeFields {
  using Measurement = decltype(E::measurement);
  static E read(FieldReader& in) {
    if constexpr (std::is_same_v<Measurement, SE3>) {
      const SE3 z = FileFields<SE3>::read(in);
      return E(SE3(z.translation(), z.quaternion()));
    } else {
      return E(FileFields<Measurement>::read(in));
    }
  }
  static void write(const E& edge, FieldWriter& out) {
    if constexpr (std::is_same_v<Measurement, SE3>) {
      write_measurement(edge.measurement, out);
    } else {
      FileFields<Measurement>::write(edge.measurement, out);
    }
  }
};

/// n, then the coordinates of n points.
template <>
struct EdgeFields<PointsObservation2> {
  static PointsObservation2 read(FieldReader& in);
  static void write(const PointsObservation2& edge, FieldWriter& out);
};
template <>
struct EdgeFields<PointsObservation3> {
  static PointsObservation3 read(FieldReader& in);
  static void write(const PointsObservation3& edge, FieldWriter& out);
};

/// The number of the end point (0 or 1), then x y θ.
template <>
struct EdgeFields<SegmentEndObservation2> {
  static SegmentEndObservation2 read(FieldReader& in);
  static void write(const SegmentEndObservation2& edge, FieldWriter& out);
};

}  // namespace boxplus
