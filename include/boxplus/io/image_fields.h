// SPDX-License-Identifier: BSD-3-Clause
// The fields of g2o's cameras, images and pairs of points: the tags of its type libraries sba, sim3 and icp.
// (io/file_fields.h includes this file.)
#pragma once

#include "boxplus/graph/information.h"
#include "boxplus/io/file_fields.h"
#include "boxplus/types/ba/depth_image.h"
#include "boxplus/types/ba/image.h"
#include "boxplus/types/ba/similarity.h"
#include "boxplus/types/ba/twist_between.h"
#include "boxplus/types/slam3d/surface_match.h"

namespace boxplus {

/// x y z qx qy qz qw. The quaternion is normalized. The writer finds the digits that were read.
template <>
struct FileFields<SE3RotationVector> {
  static SE3RotationVector read(FieldReader& in);
  static void write(const SE3RotationVector& x, FieldWriter& out);
};

/// f cx cy baseline.
template <>
struct FileFields<StereoCamera> {
  static StereoCamera read(FieldReader& in);
  static void write(const StereoCamera& x, FieldWriter& out);
};

/// fx fy cx cy baseline.
template <>
struct FileFields<StereoIntrinsics> {
  static StereoIntrinsics read(FieldReader& in);
  static void write(const StereoIntrinsics& x, FieldWriter& out);
};

/// x y z qx qy qz qw, and the intrinsics fx fy cx cy baseline. The quaternion is normalized. If the line ends
/// after the pose, the intrinsics are 300 300 320 320 0.1, with a note.
template <>
struct FileFields<StereoPose> {
  static constexpr int kOptionalFields = 5;
  static StereoPose read(FieldReader& in);
  static void write(const StereoPose& x, FieldWriter& out);
};

/// x y z qx qy qz qw of the camera on a robot, and fx fy cx cy.
template <>
struct FileFields<Product<SE3, PinholeCamera>> {
  static Product<SE3, PinholeCamera> read(FieldReader& in);
  static void write(const Product<SE3, PinholeCamera>& x, FieldWriter& out);
};

/// The same, and a baseline.
template <>
struct FileFields<Product<SE3, PinholeCamera, double>> {
  static Product<SE3, PinholeCamera, double> read(FieldReader& in);
  static void write(const Product<SE3, PinholeCamera, double>& x, FieldWriter& out);
};

/// The logarithm ω υ σ. It must be finite, with a scale between 1e-100 and 1e100 and a translation for which
/// the inverse is finite, too.
template <>
struct FileFields<LoggedSim3> {
  static LoggedSim3 read(FieldReader& in);
  static void write(const LoggedSim3& x, FieldWriter& out);
};

/// The logarithm ω υ σ, and fx fy cx cy of the first and of the second camera. g2o does not write the second
/// camera, but accepts it. Without it, its focal length is 1 and its center is 0, with a note.
template <>
struct FileFields<SimilarityCamera> {
  static constexpr int kOptionalFields = 4;
  static SimilarityCamera read(FieldReader& in);
  static void write(const SimilarityCamera& x, FieldWriter& out);
};

/// p₀ n₀ p₁ n₁, and no Ω.
template <>
struct EdgeFields<SurfaceMatch> {
  static SurfaceMatch read(FieldReader& in);
  static Information information(const SurfaceMatch& edge);
  static void write(const SurfaceMatch& edge, FieldWriter& out);
};

namespace detail {

/// The known constants of an edge, at the end of its line: a point (unless nullptr), fx fy cx cy, and bf
/// (unless nullptr). If the line ends before them, they are left unchanged, with a note.
void read_known(FieldReader& in, Vector3* point, PinholeCamera& camera, double* bf);
void write_known(FieldWriter& out, const Vector3* point, const PinholeCamera& camera, const double* bf);

}  // namespace detail

/// u v or u v u_right; after Ω, fx fy cx cy or fx fy cx cy bf. g2o does not write the fields after Ω, but
/// accepts them. Without them, images are normalized: the focal length is 1, the center is 0, and bf is 1.
template <int Rows>
struct EdgeFields<CalibratedPointImage<Rows>> {
  using Edge = CalibratedPointImage<Rows>;
  static constexpr int kOptionalFields = Rows == 2 ? 4 : 5;
  static Edge read(FieldReader& in) {
    return Edge(FileFields<Vector<double, Rows>>::read(in), PinholeCamera(1, 1, 0, 0), Rows == 2 ? 0 : 1);
  }
  static void read_rest(Edge& edge, FieldReader& in) {
    detail::read_known(in, nullptr, edge.camera, Rows == 2 ? nullptr : &edge.bf);
  }
  static void write(const Edge& edge, FieldWriter& out) {
    FileFields<Vector<double, Rows>>::write(edge.measurement, out);
  }
  static void write_rest(const Edge& edge, FieldWriter& out) {
    detail::write_known(out, nullptr, edge.camera, Rows == 2 ? nullptr : &edge.bf);
  }
};

/// The same; the known point x y z comes before fx. Without these fields, the point is (0, 0, 1).
template <int Rows>
struct EdgeFields<KnownPointImage<Rows>> {
  using Edge = KnownPointImage<Rows>;
  static constexpr int kOptionalFields = Rows == 2 ? 7 : 8;
  static Edge read(FieldReader& in) {
    return Edge(FileFields<Vector<double, Rows>>::read(in), Vector3(0, 0, 1), PinholeCamera(1, 1, 0, 0),
                Rows == 2 ? 0 : 1);
  }
  static void read_rest(Edge& edge, FieldReader& in) {
    detail::read_known(in, &edge.point, edge.camera, Rows == 2 ? nullptr : &edge.bf);
  }
  static void write(const Edge& edge, FieldWriter& out) {
    FileFields<Vector<double, Rows>>::write(edge.measurement, out);
  }
  static void write_rest(const Edge& edge, FieldWriter& out) {
    detail::write_known(out, &edge.point, edge.camera, Rows == 2 ? nullptr : &edge.bf);
  }
};

}  // namespace boxplus
