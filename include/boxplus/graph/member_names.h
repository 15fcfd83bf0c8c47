// SPDX-License-Identifier: BSD-3-Clause
// Finds out whether an error function has a member of a given name, with any signature. A member with a wrong
// signature is a mistake, but a missing member is not a mistake.
#pragma once

#include <type_traits>

namespace boxplus::detail {

/// If a class derives from E and from a struct with a member of this name, then the name is ambiguous exactly
/// if E has such a member. This test also finds templates and overloads, whose address cannot be taken.
struct NamedError {
  int error;
};
struct NamedJacobian {
  int jacobian;
};
struct NamedJacobians {
  int jacobians;
};
struct NamedCall {
  void operator()();
};
template <class E, class Named>
struct Both : E, Named {};
template <class E>
concept CanBeBase = std::is_class_v<E> && !std::is_final_v<E>;

template <class E>
inline constexpr bool kNamesError = requires {
  &E::error;
};
template <CanBeBase E>
inline constexpr bool kNamesError<E> = !requires {
  &Both<E, NamedError>::error;
};
template <class E>
inline constexpr bool kNamesJacobian = requires {
  &E::jacobian;
};
template <CanBeBase E>
inline constexpr bool kNamesJacobian<E> = !requires {
  &Both<E, NamedJacobian>::jacobian;
};
template <class E>
inline constexpr bool kNamesJacobians = requires {
  &E::jacobians;
};
template <CanBeBase E>
inline constexpr bool kNamesJacobians<E> = !requires {
  &Both<E, NamedJacobians>::jacobians;
};

/// Whether E has a member `error` or an operator(). True if this cannot be determined.
template <class E>
inline constexpr bool kHasFunction = true;
template <CanBeBase E>
inline constexpr bool kHasFunction<E> = kNamesError<E> || !requires {
  &Both<E, NamedCall>::operator();
};

/// Whether E has a member function named `jacobian` or `jacobians`. Data members may have any name.
template <class E>
inline constexpr bool kNamesJacobianFunction = (kNamesJacobian<E> &&
                                                !requires(const E& e) { sizeof(e.jacobian); }) ||
                                               (kNamesJacobians<E> &&
                                                !requires(const E& e) { sizeof(e.jacobians); });

}  // namespace boxplus::detail
