// SPDX-License-Identifier: BSD-3-Clause
#include "io/model/image_sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace boxplus {
namespace {

/// The smallest integer ≥ `least` of a size that images can have.
double image_size(double least) {
  return std::clamp(std::ceil(least), 1.0, 1e9);
}

}  // namespace

void move_center(SparseModel::Camera& camera, SparseModel::Image& image) {
  std::array<double, 2> center{1, 1};
  for (const SparseModel::Feature& feature : image.features) {
    for (std::size_t i = 0; i < 2; ++i)
      center[i] = std::max(center[i], image_size(std::abs(feature.pixel[i])));
  }
  for (SparseModel::Feature& feature : image.features)
    feature.pixel = {feature.pixel[0] + center[0], center[1] - feature.pixel[1]};
  camera.parameters[1] = center[0];
  camera.parameters[2] = center[1];
  camera.width = static_cast<std::uint64_t>(2 * center[0]);
  camera.height = static_cast<std::uint64_t>(2 * center[1]);
}

void enlarge(SparseModel::Camera& camera, const SparseModel::Image& image) {
  double width = 1, height = 1;
  for (const SparseModel::Feature& feature : image.features) {
    width = std::max(width, feature.pixel[0]);
    height = std::max(height, feature.pixel[1]);
  }
  camera.width = std::max(camera.width, static_cast<std::uint64_t>(image_size(width)));
  camera.height = std::max(camera.height, static_cast<std::uint64_t>(image_size(height)));
}

}  // namespace boxplus
