// SPDX-License-Identifier: BSD-3-Clause
// Finds out whether an error function takes vectors whose types differ from the types of its vertices.
#pragma once

#include <concepts>
#include <span>
#include <type_traits>
#include <utility>

#include "boxplus/graph/error_function.h"
#include "boxplus/graph/member_names.h"
#include "boxplus/graph/stored_estimate.h"

namespace boxplus::detail {

template <class... P>
struct Parameters {};

/// The parameters of a member function.
template <class F>
struct ParametersOf {
  using Type = void;
};
template <class R, class C, class... P>
struct ParametersOf<R (C::*)(P...) const> {
  using Type = Parameters<std::remove_cvref_t<P>...>;
};
template <class R, class C, class... P>
struct ParametersOf<R (C::*)(P...) const noexcept> : ParametersOf<R (C::*)(P...) const> {};

/// The parameters of an error function that is neither a template nor overloaded; void for all other error
/// functions.
template <class E>
struct KnownParameters {
  using Type = void;
};
template <class E>
requires requires {
  &E::error;
}
struct KnownParameters<E> : ParametersOf<decltype(&E::error)> {};
template <class E>
requires(!kNamesError<E> && requires { &E::operator(); }) struct KnownParameters<E>
    : ParametersOf<decltype(&E::operator())> {
};

template <class P>
concept PlainEigen = requires {
  typename P::PlainObject;
  requires std::derived_from<P, Eigen::PlainObjectBase<P>>;
};

/// False if P and V are vectors of different sizes or scalars. Eigen declares a conversion between them, but
/// it does not compile.
template <class P, class V>
inline constexpr bool kFits = true;
template <PlainEigen P, EigenColumn V>
inline constexpr bool kFits<P, V> = std::is_same_v<typename P::Scalar, double>&& P::ColsAtCompileTime == 1 &&
                                    (int{P::RowsAtCompileTime} == int{V::RowsAtCompileTime} ||
                                     P::RowsAtCompileTime == kDynamic || V::RowsAtCompileTime == kDynamic);

template <class P, class... V>
inline constexpr bool kAllFit = true;
template <class... P, class... V>
requires(sizeof...(P) == sizeof...(V)) inline constexpr bool kAllFit<Parameters<P...>, V...> = (kFits<P, V> &&
                                                                                                ...);

/// Whether E could be called if A, the argument between Before and After, were a vector (or a tail of
/// vectors) of another size.
template <class E, class Before, class A, class After, class Sizes = std::make_integer_sequence<int, 12>>
inline constexpr bool kTakesAnother = false;
template <class E, class... B, EigenColumn A, class... C, int... N>
inline constexpr bool
    kTakesAnother<E, Parameters<B...>, A, Parameters<C...>, std::integer_sequence<int, N...>> =
        (Callable<E, Argument<B>..., const Vector<double, N + 1>&, Argument<C>...> || ...);
template <class E, class... B, EigenColumn A, int... N>
inline constexpr bool
    kTakesAnother<E, Parameters<B...>, Tail<A>, Parameters<>, std::integer_sequence<int, N...>> =
        (Callable<E, Argument<B>..., std::span<const Vector<double, N + 1>>> || ...);

template <class E, class Before, class After>
inline constexpr bool kTakesOtherVectors = false;
template <class E, class... B, class A, class... C>
inline constexpr bool kTakesOtherVectors<E, Parameters<B...>, Parameters<A, C...>> =
    kTakesAnother<E, Parameters<B...>, A, Parameters<C...>> ||
    kTakesOtherVectors<E, Parameters<B..., A>, Parameters<C...>>;

}  // namespace boxplus::detail
