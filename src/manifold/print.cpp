// SPDX-License-Identifier: BSD-3-Clause
// operator<< for rotations, poses and similarities.
#include <ostream>
#include <span>
#include <string_view>

#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/sim3.h"
#include "boxplus/manifold/so2.h"
#include "boxplus/manifold/so3.h"

namespace boxplus {
namespace {

std::ostream& print(std::ostream& out, std::string_view name, std::span<const double> values) {
  out << name;
  std::string_view separator = "(";
  for (const double value : values) {
    out << separator << value;
    separator = ", ";
  }
  return out << ')';
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const SE2& x) {
  return print(out, SE2::kName, {x.data(), 3});
}
std::ostream& operator<<(std::ostream& out, const SE3& x) {
  return print(out, SE3::kName, {x.data(), 7});
}
std::ostream& operator<<(std::ostream& out, const SE3RotationVector& x) {
  return print(out, SE3RotationVector::kName, {x.data(), 7});
}
std::ostream& operator<<(std::ostream& out, const SO2& x) {
  return print(out, SO2::kName, {x.data(), 1});
}
std::ostream& operator<<(std::ostream& out, const SO3& x) {
  return print(out, SO3::kName, {x.data(), 4});
}
std::ostream& operator<<(std::ostream& out, const SO3RotationVector& x) {
  return print(out, SO3RotationVector::kName, {x.data(), 4});
}
std::ostream& operator<<(std::ostream& out, const S2& x) {
  return print(out, "S2", {x.data(), 3});
}
std::ostream& operator<<(std::ostream& out, const Sim3& x) {
  return print(out, "Sim3", {x.data(), 8});
}

}  // namespace boxplus
