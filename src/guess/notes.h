// SPDX-License-Identifier: BSD-3-Clause
// The notes of the initial guesses (GuessResult::note).
#pragma once

#include <string_view>

namespace boxplus::guess {

inline constexpr std::string_view kNothingMeasured = "no enabled edge measures a relative pose or position";
inline constexpr std::string_view kSingular =
    "the measured poses and positions do not determine all vertices";
inline constexpr std::string_view kAnchored =
    "some vertices are not measured in all directions and kept their estimates in the other directions";
inline constexpr std::string_view kStopped = "the run was stopped before the initial guess was finished";
inline constexpr std::string_view kNotSolved = "the linear problem of the chordal guess was not solved";
inline constexpr std::string_view kNotFinite =
    "the linear problem of the chordal guess contains NaN or infinite values";

}  // namespace boxplus::guess
