// SPDX-License-Identifier: BSD-3-Clause
// Memory that a thread keeps between calls.
#pragma once

namespace boxplus::detail {

/// One T per thread and Tag, made on first use and freed when its thread ends. Unlike a thread_local T, it
/// may be used later too: in destructors of global objects, which run after the main thread's objects are
/// freed.
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
