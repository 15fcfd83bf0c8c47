// SPDX-License-Identifier: BSD-3-Clause
// Memory that a thread keeps between calls.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

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

/// An object of type T that belongs to the calling thread and to this Tag, borrowed for the lifetime of the
/// BorrowedScratch. Nested scopes borrow different objects, so code between them may run functions that use
/// the same scratch memory. Later scopes of the same depth get the same object again, with its old value.
template <class T, class Tag>
class BorrowedScratch {
 public:
  BorrowedScratch() : lender_(thread_scratch<Lender, Tag>()) {
    if (lender_.lent == lender_.objects.size()) lender_.objects.push_back(std::make_unique<T>());
    object_ = lender_.objects[lender_.lent++].get();
  }
  ~BorrowedScratch() { --lender_.lent; }
  BorrowedScratch(const BorrowedScratch&) = delete;
  BorrowedScratch& operator=(const BorrowedScratch&) = delete;

  T& operator*() const { return *object_; }
  T* operator->() const { return object_; }

 private:
  struct Lender {
    std::vector<std::unique_ptr<T>> objects;
    std::size_t lent = 0;
  };
  Lender& lender_;
  T* object_;
};

}  // namespace boxplus::detail
