// SPDX-License-Identifier: BSD-3-Clause
// What makes a type an edge: an error function of the estimates of its vertices.
//
// Either the type has a member `error(x_1, …, x_q) const`, or it is callable itself (a lambda). Estimates
// arrive by const reference; the last arguments may be std::span<const T>, each of a type of its own, for
// edges whose arity is chosen at run time. Vectors are Vector<S, N> (base/matrix.h); a function that takes
// Eigen::Matrix<S, N, 1> is given copies (of a tail in new memory). The result is a scalar, a std::array, or
// an Eigen vector, of fixed or run-time size.
//
// Threads: optimize() calls error() and jacobians() of different edges on several threads at once, unless
// Options::threads is 1. Both are const. An edge that writes to shared or mutable data (a counter, a cache)
// must protect it.
//
//   - A function that is generic in the scalar of its arguments is differentiated exactly, by dual numbers.
//   - One that takes plain estimates only is differentiated numerically, and the Report says so.
//   - One with `jacobians(x_1, …, x_q, J_1, …, J_q) const`, where J_i is an Eigen::Ref/Map of rows ×
//     dim(x_i), brings its own. J_i = ∂ error(…, x_i ⊞ δ, …) / ∂δ at δ = 0; every entry must be set. That of
//     a span has the columns of all its elements, side by side. What is known at compile time, rows or
//     columns, is fixed in the type of J_i; the rest is Eigen::Dynamic.
//     A member function named `jacobians` or `jacobian` that cannot be called so does not compile
//     (graph/check_types.h). An edge template that brings Jacobians for some of its types only says `static
//     constexpr bool kJacobiansForSomeTypes = true`.
#pragma once

#include <array>
#include <concepts>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "boxplus/autodiff/dual.h"
#include "boxplus/graph/jacobian_source.h"
#include "boxplus/manifold/manifold.h"

namespace boxplus {

/// Stands in a list of vertex types for "any number of T".
template <class T>
struct Tail {
  using Element = T;
};

template <class V>
inline constexpr bool kIsTail = false;
template <class T>
inline constexpr bool kIsTail<Tail<T>> = true;
/// No tail stands before a type that is none.
template <class... V>
inline constexpr bool kTailsAreLast = true;
template <class V, class W, class... Rest>
inline constexpr bool kTailsAreLast<V, W, Rest...> = (!kIsTail<V> || kIsTail<W>)&&kTailsAreLast<W, Rest...>;

namespace edge {

template <class V>
struct Element {
  using Type = V;
};
template <class T>
struct Element<Tail<T>> {
  using Type = T;
};
/// T for T and for Tail<T>.
template <class V>
using ElementOf = typename Element<V>::Type;

template <class V>
struct ArgumentOf {
  using Type = const V&;
};
template <class T>
struct ArgumentOf<Tail<T>> {
  using Type = std::span<const T>;
};
/// How an estimate is handed to the error function.
template <class V>
using Argument = typename ArgumentOf<V>::Type;

template <class V, class S>
struct LiftedOf {
  using Type = boxplus::Rebind<V, S>;
};
template <class T, class S>
struct LiftedOf<Tail<T>, S> {
  using Type = Tail<boxplus::Rebind<T, S>>;
};
/// V, or the elements of the tail, over the scalar S.
template <class V, class S>
using Lifted = typename LiftedOf<V, S>::Type;

template <class E, class... A>
concept HasErrorMember = requires(const E& e, A&&... a) {
  e.error(std::forward<A>(a)...);
};

template <class E, class... A>
concept CallableAsIs = HasErrorMember<E, A...> || std::invocable<const E&, A...>;

/// An argument with Eigen's own alignment, if it is a vector or a span of vectors: what templates over
/// Eigen::Matrix<S, N, 1> ask for.
template <class T>
struct AlignedCopy {};
template <class S, int N>
struct AlignedCopy<Eigen::Matrix<S, N, 1, Eigen::DontAlign>> {
  using Type = Eigen::Matrix<S, N, 1>;
  using Argument = const Type&;
  static Type of(const Vector<S, N>& x) { return x; }
};
template <class S, int N>
struct AlignedCopy<std::span<const Eigen::Matrix<S, N, 1, Eigen::DontAlign>>> {
  using Type = std::vector<Eigen::Matrix<S, N, 1>>;
  using Argument = std::span<const Eigen::Matrix<S, N, 1>>;
  static Type of(std::span<const Vector<S, N>> x) { return {x.begin(), x.end()}; }
};

template <class A>
struct AlignedArgument {
  using Type = A;
  static A&& of(A&& a) { return std::forward<A>(a); }
};
template <class A>
requires requires {
  typename AlignedCopy<std::remove_cvref_t<A>>::Type;
}
struct AlignedArgument<A> : AlignedCopy<std::remove_cvref_t<A>> {
  using Type = typename AlignedCopy<std::remove_cvref_t<A>>::Argument;
};
template <class A>
using Aligned = typename AlignedArgument<A>::Type;

template <class E, class... A>
concept Callable = CallableAsIs<E, A...> || CallableAsIs<E, Aligned<A>...>;

template <class E, class... A>
requires Callable<E, A...>
decltype(auto) call(const E& e, A&&... a) {
  if constexpr (HasErrorMember<E, A...>) {
    return e.error(std::forward<A>(a)...);
  } else if constexpr (CallableAsIs<E, A...>) {
    return e(std::forward<A>(a)...);
  } else {
    auto result = call<E, Aligned<A>...>(e, AlignedArgument<A>::of(std::forward<A>(a))...);
    return result;  // by value: a reference might refer to the copies
  }
}

template <class E, class... V>
using Result = std::remove_cvref_t<decltype(call(std::declval<const E&>(), std::declval<Argument<V>>()...))>;

template <class R>
inline constexpr int kRows = [] {
  if constexpr (requires { R::SizeAtCompileTime; }) {
    return static_cast<int>(R::SizeAtCompileTime);
  } else if constexpr (requires { std::tuple_size<R>::value; }) {
    return static_cast<int>(std::tuple_size<R>::value);
  } else if constexpr (requires(const R& r) { r.size(); }) {
    return kDynamic;
  } else {
    return 1;
  }
}();

template <class R>
int row_count(const R& result) {
  if constexpr (requires { result.size(); }) {
    return static_cast<int>(result.size());
  } else {
    return 1;
  }
}

/// A result that owns its numbers. An unevaluated Eigen expression does not: it refers to temporaries that
/// died with the function that returned it.
template <class R>
inline constexpr bool kOwnsItsNumbers = [] {
  if constexpr (requires { typename R::PlainObject; }) {
    return std::derived_from<R, Eigen::PlainObjectBase<R>>;
  } else {
    return true;
  }
}();

template <class E, class... A>
auto evaluate(const E& e, A&&... a) {
  using R = std::remove_cvref_t<decltype(call(e, std::forward<A>(a)...))>;
  static_assert(
      kOwnsItsNumbers<R>,
      "the error function returns an unevaluated Eigen expression, which refers to dead temporaries: "
      "give it a return type, or end it with .eval()");
  return call(e, std::forward<A>(a)...);
}

/// Row i of a result that may be a scalar.
template <class R>
decltype(auto) row(const R& result, int i) {
  if constexpr (requires { result.size(); }) {
    return result[static_cast<std::size_t>(i)];
  } else {
    return (result);
  }
}

/// Throws InvalidArgument: an error function changed its number of rows.
[[noreturn]] void throw_row_count(int expected, int actual);

template <class R>
void check_row_count(const R& result, int expected) {
  if constexpr (kRows<R> == kDynamic) {
    if (row_count(result) != expected) throw_row_count(expected, row_count(result));
  }
}

template <class R>
void copy_rows(const R& result, int rows, double* out) {
  check_row_count(result, rows);
  for (int i = 0; i < rows; ++i) out[i] = row(result, i);
}

/// Sum of the tangent sizes, or kDynamic.
template <class... V>
inline constexpr int kCols = [] {
  int sum = 0;
  bool dynamic = false;
  ((kIsTail<V> || Manifold<ElementOf<V>>::kDim == kDynamic ? void(dynamic = true)
                                                           : void(sum += Manifold<ElementOf<V>>::kDim)),
   ...);
  return dynamic ? kDynamic : sum;
}();

/// Dual numbers carry all columns at once up to this many; more columns go in passes of kDualChunk.
inline constexpr int kDualLimit = 24;
inline constexpr int kDualChunk = 8;
template <class... V>
inline constexpr int kDualSize = (kCols<V...> != kDynamic && kCols<V...> <= kDualLimit && kCols<V...> > 0)
                                     ? kCols<V...>
                                     : kDualChunk;

template <class... V>
using DualFor = Dual<double, kDualSize<V...>>;

/// What the rows of a result are.
template <class R>
struct RowScalar {
  using Type = R;
};
template <class R>
requires requires {
  typename R::PlainObject;
}
struct RowScalar<R> {
  using Type = typename R::Scalar;
};
template <class R>
requires requires {
  typename R::value_type;
} &&(!requires { typename R::PlainObject; }) struct RowScalar<R> {
  using Type = typename R::value_type;
};

/// What a call would return, found without compiling the call: Eigen's conversions do not survive that.
template <class E, class... A>
struct UnevaluatedResult {
  using Type = std::invoke_result_t<const E&, A...>;
};
template <class E, class... A>
requires HasErrorMember<E, A...>
struct UnevaluatedResult<E, A...> {
  using Type = decltype(std::declval<const E&>().error(std::declval<A>()...));
};
template <class E, class... A>
requires(!CallableAsIs<E, A...>) struct UnevaluatedResult<E, A...> : UnevaluatedResult<E, Aligned<A>...> {
};

/// The function carries S from its arguments to its result. (One that takes plain Eigen vectors can be called
/// with vectors of S, since Eigen offers to convert them, but what it returns is plain.)
template <class E, class S, class... A>
concept Carries = Callable<E, A...> &&
    std::is_same_v<typename RowScalar<std::remove_cvref_t<typename UnevaluatedResult<E, A...>::Type>>::Type,
                   S>;

template <class E, class S, class... V>
concept DifferentiableWith =
    (LiftableManifold<ElementOf<V>, S> && ...) && Carries<E, S, Argument<Lifted<V, S>>...>;

/// E asks for numeric Jacobians (see Numeric).
template <class E>
concept WantsNumeric = requires {
  requires E::kNumeric;
};

/// E declares `static constexpr bool kRigid = true`: its error tells all about the position of one vertex in
/// the frame of another, or of one in the world; so it changes with every similarity of some of its vertices,
/// but for a rigid motion of all of them. Spares the search for gauge freedom.
template <class E>
inline constexpr bool kIsRigid = [] {
  if constexpr (requires { E::kRigid; }) {
    return static_cast<bool>(E::kRigid);
  } else {
    return false;
  }
}();

/// Exact Jacobians are available.
template <class E, class... V>
inline constexpr bool kDifferentiable = [] {
  if constexpr (WantsNumeric<E>) {
    return false;
  } else if constexpr (requires { requires DifferentiableWith<E, DualFor<V...>, V...>; }) {
    return true;
  } else {
    return false;
  }
}();

/// The columns of one argument.
template <class V, int Rows>
using JacobianBlock = Eigen::Map<Matrix<double, Rows, kIsTail<V> ? kDynamic : Manifold<ElementOf<V>>::kDim>>;

template <class E, class... V>
inline constexpr bool kAnalytic = requires(const E& e, Argument<V>... x,
                                           JacobianBlock<V, kRows<Result<E, V...>>>... J) {
  e.jacobians(x..., J...);
};

/// What optimize() takes unless it is told to differentiate numerically.
template <class E, class... V>
inline constexpr JacobianSource kJacobianSource = kAnalytic<E, V...>         ? JacobianSource::kAnalytic
                                                  : kDifferentiable<E, V...> ? JacobianSource::kAutomatic
                                                                             : JacobianSource::kNumeric;

}  // namespace edge

/// E is an error function of the vertex types V... (T, or Tail<T> in the last places).
template <class E, class... V>
concept EdgeType = std::copy_constructible<E> && sizeof...(V) > 0 && edge::Callable<E, edge::Argument<V>...>;

/// Wraps an error function whose Jacobians shall be numeric.
template <class E>
struct Numeric {
  static constexpr bool kNumeric = true;
  E function;
  template <class... A>
  requires edge::Callable<E, A...>
  auto operator()(A&&... a) const { return edge::call(function, std::forward<A>(a)...); }
};
template <class E>
Numeric(E) -> Numeric<E>;

}  // namespace boxplus
