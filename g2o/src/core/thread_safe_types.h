// SPDX-License-Identifier: BSD-3-Clause
// The types that are declared thread-safe at the moment. A type T is declared as long as a ThreadSafe<T>
// object exists.
#pragma once

#include <cstdint>
#include <typeinfo>

namespace g2o {
namespace internal {

/// Whether objects of exactly this type may be evaluated on several threads at once. May be called on any
/// thread.
bool is_thread_safe(const std::type_info& type);
/// A counter that changes whenever a ThreadSafe<T> object is created or destroyed.
std::uint64_t thread_safe_types_revision();

}  // namespace internal
}  // namespace g2o
