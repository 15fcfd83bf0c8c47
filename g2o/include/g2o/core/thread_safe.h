// SPDX-License-Identifier: BSD-3-Clause
// Declares that edges or robust kernels of a client's type are thread-safe:
//
//     const g2o::ThreadSafe<MyEdge> kMyEdgeIsThreadSafe;
//
// Objects of other client types are evaluated only on the thread that calls optimize(). A class that derives
// from a type of the library needs its own declaration.
#pragma once
#ifndef G2O_THREAD_SAFE_H
#define G2O_THREAD_SAFE_H

#include <typeinfo>

#include "g2o/core/g2o_core_api.h"

namespace g2o {
namespace internal {

G2O_CORE_API void declare_thread_safe(const std::type_info& type, bool declared);

}  // namespace internal

/// While an object of this class exists, the library may evaluate objects of type T on several threads at
/// once. This does not include objects of classes that derive from T. If T is an edge, computeError() and
/// linearizeOplus() may read the edge, its vertices and its parameters, but may change only the edge. An edge
/// with numeric Jacobians is not thread-safe, because it moves its vertices. If T is a robust kernel,
/// robustify() may only read the kernel.
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
