// SPDX-License-Identifier: BSD-3-Clause
// Which names the members of an error function have, whatever their signatures: to tell a mistake from
// absence.
#pragma once

#include <type_traits>

namespace boxplus::edge {

/// A second member of the same name makes a name ambiguous, be it that of a template or of overloads.
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

/// A member error, an operator(), or a type that cannot be asked.
template <class E>
inline constexpr bool kHasFunction = true;
template <CanBeBase E>
inline constexpr bool kHasFunction<E> = kNamesError<E> || !requires {
  &Both<E, NamedCall>::operator();
};

/// A member function named like a Jacobian. Members that hold data may have any name.
template <class E>
inline constexpr bool kNamesJacobianFunction = (kNamesJacobian<E> &&
                                                !requires(const E& e) { sizeof(e.jacobian); }) ||
                                               (kNamesJacobians<E> &&
                                                !requires(const E& e) { sizeof(e.jacobians); });

}  // namespace boxplus::edge
