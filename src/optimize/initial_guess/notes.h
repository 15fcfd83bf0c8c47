// SPDX-License-Identifier: BSD-3-Clause
// What the initial guesses say about themselves.
#pragma once

#include <string_view>

namespace boxplus::guess {

inline constexpr std::string_view kNothingMeasured = "no enabled edge measures a relative pose or position";
inline constexpr std::string_view kSingular =
    "the measured poses and positions do not determine all vertices";
inline constexpr std::string_view kAnchored =
    "some vertices are not measured in all directions and kept their estimates there";
inline constexpr std::string_view kStopped = "the initial guess was not finished when the run was to end";
inline constexpr std::string_view kNotSolved = "the linear problem of the chordal guess was not solved";
inline constexpr std::string_view kNotFinite = "the linear problem of the chordal guess is not finite";

}  // namespace boxplus::guess
