// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "boxplus/types/ba/camera.h"

namespace boxplus::detail {
namespace {

/// The largest size of a coefficient of distortion; 0 if the parameter is none. At a tenth of the focal
/// length from the center, a coefficient of this size moves the image as far as that distance.
double largest_coefficient(std::string_view name) {
  constexpr double kMost = 100;
  if (name == "k" || name == "p1" || name == "p2") return kMost;
  if (name.size() != 2 || name[0] != 'k' || name[1] < '1' || name[1] > '9') return 0;
  return std::pow(kMost, name[1] - '0');
}

}  // namespace

std::string implausible_intrinsics(const double* parameters, std::span<const std::string_view> names,
                                   int focal_lengths) {
  for (int i = 0; i < focal_lengths; ++i) {
    if (parameters[i] <= 0)
      return fmt::format("{} is {:.4g}, but focal lengths are positive", names[i], parameters[i]);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double most = largest_coefficient(names[i]);
    if (most > 0 && std::abs(parameters[i]) > most)
      return fmt::format("{} is {:.4g}, but coefficients of distortion do not exceed {:.0f}", names[i],
                         parameters[i], most);
  }
  return {};
}

}  // namespace boxplus::detail
