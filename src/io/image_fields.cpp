// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/image_fields.h"

#include <array>
#include <cmath>

namespace boxplus {
namespace {

/// A pose whose quaternion is normalized.
SE3 read_unit_pose(FieldReader& in) {
  const SE3 x = FileFields<SE3>::read(in);
  return SE3(x.translation(), x.quaternion());
}

/// Steps may have changed the norm of the quaternion by rounding. A reader would normalize it, so it is
/// normalized here.
template <class Pose>
void write_unit_pose(const Pose& x, FieldWriter& out) {
  write_measurement(SE3(x.translation(), x.quaternion()), out);
}

}  // namespace

SE3RotationVector FileFields<SE3RotationVector>::read(FieldReader& in) {
  const SE3 x = read_unit_pose(in);
  return SE3RotationVector::from_unit(x.translation(), x.quaternion());
}

void FileFields<SE3RotationVector>::write(const SE3RotationVector& x, FieldWriter& out) {
  write_unit_pose(x, out);
}

StereoCamera FileFields<StereoCamera>::read(FieldReader& in) {
  StereoCamera x;
  in.numbers(x.parameters.data(), 4, "a camera parameter (f cx cy baseline)");
  return x;
}

void FileFields<StereoCamera>::write(const StereoCamera& x, FieldWriter& out) {
  for (const double value : x.parameters) out.number(value);
}

StereoIntrinsics FileFields<StereoIntrinsics>::read(FieldReader& in) {
  StereoIntrinsics x;
  in.numbers(x.parameters.data(), 4, "a camera parameter (fx fy cx cy)");
  x.baseline = in.number("the baseline");
  return x;
}

void FileFields<StereoIntrinsics>::write(const StereoIntrinsics& x, FieldWriter& out) {
  for (const double value : x.parameters) out.number(value);
  out.number(x.baseline);
}

StereoPose FileFields<StereoPose>::read(FieldReader& in) {
  StereoPose x;
  x.pose = read_unit_pose(in);
  if (!in.at_end()) {
    x.intrinsics = FileFields<StereoIntrinsics>::read(in);
  } else {
    in.note("the line has no intrinsics, so fx fy cx cy baseline are 300 300 320 320 0.1");
  }
  return x;
}

void FileFields<StereoPose>::write(const StereoPose& x, FieldWriter& out) {
  write_unit_pose(x.pose, out);
  FileFields<StereoIntrinsics>::write(x.intrinsics, out);
}

Product<SE3, PinholeCamera> FileFields<Product<SE3, PinholeCamera>>::read(FieldReader& in) {
  const SE3 pose = FileFields<SE3>::read(in);
  PinholeCamera camera;
  in.numbers(camera.parameters.data(), 4, "a camera parameter (fx fy cx cy)");
  return Product<SE3, PinholeCamera>(pose, camera);
}

void FileFields<Product<SE3, PinholeCamera>>::write(const Product<SE3, PinholeCamera>& x, FieldWriter& out) {
  FileFields<SE3>::write(x.get<0>(), out);
  for (const double value : x.get<1>().parameters) out.number(value);
}

Product<SE3, PinholeCamera, double> FileFields<Product<SE3, PinholeCamera, double>>::read(FieldReader& in) {
  const Product<SE3, PinholeCamera> camera = FileFields<Product<SE3, PinholeCamera>>::read(in);
  return Product<SE3, PinholeCamera, double>(camera.get<0>(), camera.get<1>(), in.number("the baseline"));
}

void FileFields<Product<SE3, PinholeCamera, double>>::write(const Product<SE3, PinholeCamera, double>& x,
                                                            FieldWriter& out) {
  FileFields<Product<SE3, PinholeCamera>>::write(Product<SE3, PinholeCamera>(x.get<0>(), x.get<1>()), out);
  out.number(x.get<2>());
}

LoggedSim3 FileFields<LoggedSim3>::read(FieldReader& in) {
  constexpr double kSmallest = 1e-100, kLargest = 1e100;
  const FieldPlace place = in.place();
  Vector<double, 7> logarithm;
  in.numbers(logarithm.data(), 7, "a number of the logarithm of a similarity");
  LoggedSim3 x(logarithm);
  const Sim3& value = x.value();
  const double s = value.scale(), farthest = value.translation().cwiseAbs().maxCoeff();
  const bool is_finite = std::isfinite(value.quaternion().squared_norm()) && value.translation().allFinite();
  if (!(is_finite && s > kSmallest && s < kLargest && farthest < kLargest && farthest < kLargest * s)) {
    in.fail(place,
            "expected the logarithm of a similarity with a scale between 1e-100 and 1e100 and a finite "
            "translation");
  }
  return x;
}

void FileFields<LoggedSim3>::write(const LoggedSim3& x, FieldWriter& out) {
  for (const double value : x.logarithm()) out.number(value);
}

SimilarityCamera FileFields<SimilarityCamera>::read(FieldReader& in) {
  SimilarityCamera x;
  x.similarity = FileFields<LoggedSim3>::read(in);
  in.numbers(x.first.parameters.data(), 4, "a camera parameter (fx fy cx cy)");
  if (!in.at_end()) {
    in.numbers(x.second.parameters.data(), 4, "a parameter of the second camera (fx fy cx cy)");
  } else {
    in.note("the line has no second camera, so the images of that camera are normalized");
  }
  return x;
}

void FileFields<SimilarityCamera>::write(const SimilarityCamera& x, FieldWriter& out) {
  FileFields<LoggedSim3>::write(x.similarity, out);
  for (const double value : x.first.parameters) out.number(value);
  for (const double value : x.second.parameters) out.number(value);
}

SurfaceMatch EdgeFields<SurfaceMatch>::read(FieldReader& in) {
  Vector<double, 12> v;
  const char* const what = "a coordinate of a point or of a normal";
  in.numbers(v.data(), 3, what);
  const FieldPlace place = in.place();
  in.numbers(v.data() + 3, 9, what);
  if (!(v.segment<3>(3).norm() > 0)) in.fail(place, "expected a normal other than zero");
  return {v.segment<3>(0), v.segment<3>(3), v.segment<3>(6), v.segment<3>(9)};
}

Information EdgeFields<SurfaceMatch>::information(const SurfaceMatch& edge) {
  const Matrix<double, 3, 3> omega = edge.information();
  const std::array upper{omega(0, 0), omega(0, 1), omega(0, 2), omega(1, 1), omega(1, 2), omega(2, 2)};
  return Information::upper_triangle(upper, 3);
}

void EdgeFields<SurfaceMatch>::write(const SurfaceMatch& edge, FieldWriter& out) {
  for (const Vector3& v : {edge.measurement, edge.normal, edge.other_point, edge.other_normal})
    FileFields<Vector3>::write(v, out);
}

void detail::read_known(FieldReader& in, Vector3* point, PinholeCamera& camera, double* bf) {
  if (in.at_end()) {
    in.note(point
                ? "the line ends without the known point and the camera, so the point is (0, 0, 1), and the "
                  "image is normalized"
                : "the line ends without the camera, so the image is normalized (focal length 1, center 0)");
    return;
  }
  if (point) in.numbers(point->data(), 3, "a coordinate of the known point");
  in.numbers(camera.parameters.data(), 4, "a camera parameter (fx fy cx cy)");
  if (bf) *bf = in.number("bf (the baseline times fx)");
}

void detail::write_known(FieldWriter& out, const Vector3* point, const PinholeCamera& camera,
                         const double* bf) {
  if (point) FileFields<Vector3>::write(*point, out);
  for (const double value : camera.parameters) out.number(value);
  if (bf) out.number(*bf);
}

}  // namespace boxplus
