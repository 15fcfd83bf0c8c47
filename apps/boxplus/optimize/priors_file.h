// SPDX-License-Identifier: BSD-3-Clause
// The CSV file with priors on images (position_priors.h describes its columns).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/base/matrix.h"

namespace boxplus::app {

/// The priors on one image.
struct ImagePriors {
  std::string image;
  std::optional<Vector3> position, gravity;  ///< gravity has length 1
  Vector3 sigma = Vector3::Ones();
  double gravity_sigma = 0.02;
  std::int64_t line = 0;
};

/// Reads a row for each image. Throws InputError, with `name` as the name of the file.
std::vector<ImagePriors> parse_priors(std::string_view text, const std::string& name);

}  // namespace boxplus::app
