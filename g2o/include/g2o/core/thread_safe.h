// SPDX-License-Identifier: BSD-3-Clause
// Declares that a client's type may be evaluated on several threads at once:
//
//     const g2o::ThreadSafe<MyEdge> kMyEdgeIsThreadSafe;
//
// Types that are not declared are evaluated on the thread that calls optimize(). A subclass of a ready-made
// type needs its own declaration.
#pragma once
#ifndef G2O_THREAD_SAFE_H
#define G2O_THREAD_SAFE_H

#include <typeinfo>

#include "g2o/core/g2o_core_api.h"

namespace g2o {
namespace internal {

G2O_CORE_API void declare_thread_safe(const std::type_info& type, bool declared);

}  // namespace internal

/// As long as this declaration lives, objects of type T (not of its subclasses) may be evaluated on several
/// threads at once. computeError() and linearizeOplus() of such an edge read the edge, its vertices and its
/// parameters, and change only the edge. An edge with numeric Jacobians is not thread-safe, because they move
/// its vertices. If T is a robust kernel, robustify() only reads the kernel.
template <class T>
class ThreadSafe {
 public:
  ThreadSafe() { internal::declare_thread_safe(typeid(T), true); }
  ~ThreadSafe() { internal::declare_thread_safe(typeid(T), false); }
  ThreadSafe(const ThreadSafe&) = delete;
  ThreadSafe& operator=(const ThreadSafe&) = delete;
};

}  // namespace g2o

#endif  // G2O_THREAD_SAFE_H
