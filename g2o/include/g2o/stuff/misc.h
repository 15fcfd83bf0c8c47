// SPDX-License-Identifier: BSD-3-Clause
// Small functions that clients use: for angles, signs and intervals.
#pragma once
#ifndef G2O_STUFF_MISC_H
#define G2O_STUFF_MISC_H

#include <cmath>
#include <iostream>
#include <memory>

namespace g2o {

constexpr double cst(long double v) {
  return static_cast<double>(v);
}

inline constexpr double const_pi() {
  return 3.14159265358979323846;
}

using std::make_unique;  // clients also call g2o::make_unique()

template <typename T>
inline T square(T x) {
  return x * x;
}

template <typename T>
inline T hypot(T x, T y) {
  return static_cast<T>(std::sqrt(x * x + y * y));
}

template <typename T>
inline T hypot_sqr(T x, T y) {
  return x * x + y * y;
}

inline double deg2rad(double degree) {
  return degree * (const_pi() / 180);
}

inline double rad2deg(double rad) {
  return rad * (180 / const_pi());
}

/// Returns the equivalent angle in (−π, π]. If the angle is already in this range, returns exactly the same
/// value.
inline double normalize_theta(double theta) {
  if (theta > -const_pi() && theta <= const_pi()) return theta;
  const double turns = std::ceil((theta - const_pi()) / (2 * const_pi()));
  const double wrapped = theta - turns * 2 * const_pi();
  if (wrapped > const_pi()) return wrapped - 2 * const_pi();
  return wrapped <= -const_pi() ? wrapped + 2 * const_pi() : wrapped;
}

inline double inverse_theta(double theta) {
  return normalize_theta(theta + const_pi());
}

/// Returns the direction (radians) halfway between two directions.
inline double average_angle(double theta1, double theta2) {
  const double x = std::cos(theta1) + std::cos(theta2);
  const double y = std::sin(theta1) + std::sin(theta2);
  return x == 0 && y == 0 ? 0 : std::atan2(y, x);
}

/// Returns the sign of x: −1, 0 or 1.
template <typename T>
inline int sign(T x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

template <typename T>
inline T clamp(T lower, T x, T upper) {
  return x < lower ? lower : x > upper ? upper : x;
}

/// Returns x plus a multiple of the interval's length, so that the result is in [lower, upper).
template <typename T>
inline T wrap(T lower, T x, T upper) {
  const T length = upper - lower;
  x = static_cast<T>(lower + std::fmod(x - lower, length));
  return x < lower ? x + length : x;
}

/// Returns whether an array contains a NaN. `nan_index` receives the index of the first NaN.
template <typename T>
inline bool arrayHasNaN(const T* array, int size, int* nan_index = nullptr) {
  for (int i = 0; i < size; ++i) {
    if (!std::isnan(array[i])) continue;
    if (nan_index != nullptr) *nan_index = i;
    return true;
  }
  return false;
}

/// Calls a function of a library, so that the linker includes the object file that defines the function.
struct ForceLinker {
  explicit ForceLinker(void (*function)(void)) { (function)(); }
};

}  // namespace g2o

#endif  // G2O_STUFF_MISC_H
