// SPDX-License-Identifier: BSD-3-Clause
// Calls of PETSc with exceptions instead of messages.
#pragma once

#include <petscsys.h>

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace boxplus::petsc {

/// Starts PETSc if the program has not done so. Throws Error if PETSc cannot start, or was ended.
void start();
/// Whether objects of PETSc may still be destroyed.
bool is_running();

/// While an object of this class exists, the thread may call PETSc. PETSc then reads the given database of
/// options, and prints no errors.
class Calls {
 public:
  /// Throws Error if the program has ended PETSc or MPI.
  explicit Calls(PetscOptions options);
  ~Calls();
  Calls(const Calls&) = delete;
  Calls& operator=(const Calls&) = delete;

  /// Throws if `code` is an error: InvalidArgument for what options can cause, std::bad_alloc if memory runs
  /// out, otherwise Error.
  void operator()(PetscErrorCode code) const {
    if (code != 0) fail(code);
  }

 private:
  [[noreturn]] void fail(PetscErrorCode code) const;
  static PetscErrorCode take_message(MPI_Comm, int, const char*, const char*, PetscErrorCode,
                                     PetscErrorType type, const char* message, void* calls);

  std::lock_guard<std::mutex> alone_;
  PetscOptions options_;
  std::string message_;         // of the last error
  bool has_no_memory_ = false;  // whether memory ran out, which may lead to other errors
};

/// Whether an object of PETSc has this type.
template <class T>
bool is_type(const Calls& calls, T object, const char* type) {
  PetscBool same = PETSC_FALSE;
  calls(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(object), type, &same));
  return same;
}

/// An object of PETSc, which Destroy destroys.
template <class T, PetscErrorCode (*Destroy)(T*)>
class Owned {
 public:
  Owned() = default;
  ~Owned() { reset(); }
  Owned(Owned&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  operator T() const { return object_; }
  /// Where PETSc writes a new object.
  T* out() {
    reset();
    return &object_;
  }
  void reset() {
    if (object_ != nullptr && is_running()) (void)Destroy(&object_);
    object_ = nullptr;
  }

 private:
  T object_ = nullptr;
};

using Options = Owned<PetscOptions, PetscOptionsDestroy>;

/// The names in a text of options, with their values, which may be empty. Throws InvalidArgument if the text
/// does not consist of names with a '-', each with at most one value.
std::map<std::string, std::string> parse_options(const std::string& text);
/// A database with the options of the text. Starts PETSc.
Options make_options(const std::string& text);

}  // namespace boxplus::petsc
