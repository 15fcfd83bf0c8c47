// SPDX-License-Identifier: BSD-3-Clause
// Memory that a thread keeps between calls.
#pragma once

namespace boxplus::detail {

/// Returns the object of type T that belongs to the calling thread and to this Tag. The first call creates
/// the object, and the end of the thread destroys it. A later call creates a new object; a thread_local T
/// could not be used any more. Destructors of global objects need this, because they run after the
/// thread_local objects of the main thread are destroyed.
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
