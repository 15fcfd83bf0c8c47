// SPDX-License-Identifier: BSD-3-Clause
// The types that are declared by SideBySide.
#pragma once

#include <cstdint>
#include <typeinfo>

namespace g2o {
namespace internal {

/// Whether objects of exactly this type may be worked on side by side. From any thread.
bool bears_threads(const std::type_info& type);
/// Counts the declarations that came and went.
std::uint64_t bearing_types_revision();

}  // namespace internal
}  // namespace g2o
