// SPDX-License-Identifier: BSD-3-Clause
// The frame of a pose or point, for initial guesses: a rotation and a translation in 2 or 3 dimensions.
#pragma once

#include <array>
#include <concepts>

namespace boxplus::detail {

/// A pose (T_world_body), or a point in the world, which has no rotation.
struct Frame {
  int dimension = 0;                    ///< 2 or 3
  bool has_rotation = false;            ///< false if it is a point
  std::array<double, 9> rotation{};     ///< dimension × dimension, row-major
  std::array<double, 3> translation{};  ///< meters
};

/// Specialize this trait for a vertex type that is a pose or a point, so that initial guesses can set it:
///   static Frame get(const T&);   static void set(T&, const Frame&);
template <class T>
struct FrameTrait {};

template <class T>
concept FrameType = requires(const T& x, T& out, const Frame& frame) {
  { FrameTrait<T>::get(x) } -> std::same_as<Frame>;
  FrameTrait<T>::set(out, frame);
};

/// A measured relation between the frames of two vertices of an edge: T_to ≈ T_from · (rotation,
/// translation).
struct RelativeFrame {
  static constexpr int kWorld = -1;
  int from = 0;  ///< position of the vertex within the edge, or kWorld
  int to = 1;
  Frame motion;  ///< if it has no rotation, only the position of `to` is measured
  /// First index and number of the error rows in meters, then of the error rows that are angles.
  int translation_row = 0, translation_rows = 0;
  int rotation_row = 0, rotation_rows = 0;
  double rotation_unit = 1;  ///< units of the error per radian (½ for vector parts of quaternions)
};

}  // namespace boxplus::detail
