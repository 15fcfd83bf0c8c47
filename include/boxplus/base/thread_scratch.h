// SPDX-License-Identifier: BSD-3-Clause
// Memory that a thread keeps between calls.
#pragma once

namespace boxplus::detail {

/// The T of the calling thread for this Tag. It is created on first use, and freed when its thread ends.
/// Unlike a thread_local T, it is created again if it is used after that, as by destructors of global
/// objects, which run after the main thread's thread_local objects are destroyed.
template <class T, class Tag>
T& thread_scratch() {
  struct Owner {
    T** memory;
    ~Owner() {
      delete *memory;
      *memory = nullptr;
    }
  };
  thread_local T* memory = nullptr;
  thread_local const Owner owner{&memory};
  (void)owner;
  if (memory == nullptr) memory = new T();
  return *memory;
}

}  // namespace boxplus::detail
