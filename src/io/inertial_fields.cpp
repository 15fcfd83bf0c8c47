// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/inertial_fields.h"

#include <fmt/format.h>

namespace boxplus {
namespace {

template <class V>
V read_vector(FieldReader& in, const char* what) {
  V v;
  in.numbers(v.data(), static_cast<int>(v.size()), what);
  return v;
}

template <class V>
void write_vector(const V& v, FieldWriter& out) {
  for (int i = 0; i < v.size(); ++i) out.number(v[i]);
}

}  // namespace

S2 FileFields<S2>::read(FieldReader& in) {
  const FieldPlace place = in.place();
  const auto v = read_vector<Vector3>(in, "a coordinate of the direction");
  // The length of a scaled vector neither overflows nor underflows.
  const double largest = v.cwiseAbs().maxCoeff();
  if (!(largest > 0)) in.fail(place, "expected a direction, got the zero vector");
  const double norm = v.norm();
  return norm > 0.5 && norm < 2 ? S2(v) : S2(Vector3((v / largest).normalized()));
}

void FileFields<S2>::write(const S2& x, FieldWriter& out) {
  write_vector(x.vector(), out);
}

InertialBetween EdgeFields<InertialBetween>::read(FieldReader& in) {
  InertialMotion motion;
  const SE3 pose = FileFields<SE3>::read(in);
  motion.position = pose.translation();
  motion.rotation = pose.quaternion();
  motion.velocity = read_vector<Vector3>(in, "a change of the velocity");
  const FieldPlace duration = in.place();
  motion.seconds = in.number("the duration");
  if (motion.seconds <= 0)
    in.fail(duration, fmt::format("expected a positive duration, got {}", motion.seconds));
  motion.bias = read_vector<ImuBias>(in, "a bias");
  for (int i = 0; i < motion.bias_jacobian.rows(); ++i)
    motion.bias_jacobian.row(i) = read_vector<ImuBias>(in, "a derivative with respect to the biases");
  return InertialBetween(motion, read_vector<Vector3>(in, "the acceleration of a falling body"));
}

void EdgeFields<InertialBetween>::write(const InertialBetween& edge, FieldWriter& out) {
  const InertialMotion& motion = edge.motion;
  write_vector(motion.position, out);
  const auto& q = motion.rotation;
  for (const double value : {q.x, q.y, q.z, q.w}) out.number(value);
  write_vector(motion.velocity, out);
  out.number(motion.seconds);
  write_vector(motion.bias, out);
  for (int i = 0; i < motion.bias_jacobian.rows(); ++i) write_vector(motion.bias_jacobian.row(i), out);
  write_vector(edge.gravity, out);
}

}  // namespace boxplus
