// SPDX-License-Identifier: BSD-3-Clause
// The types that a ThreadSafe object declares.
#pragma once

#include <cstdint>
#include <typeinfo>

namespace g2o {
namespace internal {

/// Whether objects of exactly this type may be evaluated on several threads at once. May be called on any
/// thread.
bool is_thread_safe(const std::type_info& type);
/// Changes with every declaration that is made or withdrawn.
std::uint64_t thread_safe_types_revision();

}  // namespace internal
}  // namespace g2o
