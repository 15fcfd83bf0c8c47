// SPDX-License-Identifier: BSD-3-Clause
// The error function that makes a type an edge: a function of the estimates of the edge's vertices.
//
// Either the type has a member `error(x_1, …, x_q) const`, or it is callable itself (a lambda). Estimates are
// passed by const reference. If the arity of the edge is chosen at run time, the last arguments are
// std::span<const T>, each with a different T. Vectors are Vector<S, N> (base/matrix.h). A function that
// takes Eigen::Matrix<S, N, 1> gets copies of its arguments; copying a span of vectors allocates memory. The
// result is a scalar, a std::array, or an Eigen vector, of fixed or run-time size.
//
// Threads: optimize() calls error() and jacobians() of different edges on several threads at once, unless
// Options::threads is 1. Both functions are const. An edge that writes to shared or mutable data (a counter,
// a cache) must protect it. They may evaluate other edges of the graph (chi2(), error(), jacobian()).
//
// There are three ways to get Jacobians:
//   - If the function is generic in the scalar of its arguments, dual numbers differentiate it exactly.
//   - If it only takes estimates of doubles, it is differentiated numerically, and the Report says so.
//   - If the type has a member `jacobians(x_1, …, x_q, J_1, …, J_q) const`, that function computes the
//     Jacobians. J_i is an Eigen::Ref or Map of rows × dim(x_i) for ∂ error(…, x_i ⊞ δ, …) / ∂δ at δ = 0; the
//     function must set every entry. The J_i of a span has the columns of all elements, side by side. The
//     type of J_i has a fixed number of rows (columns) if that number is known at compile time, and
//     Eigen::Dynamic otherwise. If a member function is named `jacobians` or `jacobian` but cannot be
//     called like this, the edge does not compile (graph/check_types.h). If an edge template has
//     Jacobians for only some of its types, it declares `static constexpr bool kJacobiansForSomeTypes =
//     true`.
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

namespace boxplus::detail {

/// In a list of vertex types, stands for any number of vertices of type T.
template <class T>
struct Tail {
  using Element = T;
};

template <class V>
inline constexpr bool kIsTail = false;
template <class T>
inline constexpr bool kIsTail<Tail<T>> = true;
/// Whether all tails come after all other types.
template <class... V>
inline constexpr bool kTailsAreLast = true;
template <class V, class W, class... Rest>
inline constexpr bool kTailsAreLast<V, W, Rest...> = (!kIsTail<V> || kIsTail<W>)&&kTailsAreLast<W, Rest...>;

template <class V>
struct Element {
  using Type = V;
};
template <class T>
struct Element<Tail<T>> {
  using Type = T;
};
/// T, if V is T or Tail<T>.
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
/// The type of the parameter by which the error function receives the estimate (or a tail of estimates).
template <class V>
using Argument = typename ArgumentOf<V>::Type;

template <class V, class S>
struct LiftedOf {
  using Type = detail::Rebind<V, S>;
};
template <class T, class S>
struct LiftedOf<Tail<T>, S> {
  using Type = Tail<detail::Rebind<T, S>>;
};
/// V over the scalar S. For a tail, a tail of elements over S.
template <class V, class S>
using Lifted = typename LiftedOf<V, S>::Type;

template <class E, class... A>
concept HasErrorMember = requires(const E& e, A&&... a) {
  e.error(std::forward<A>(a)...);
};

template <class E, class... A>
concept CallableAsIs = HasErrorMember<E, A...> || std::invocable<const E&, A...>;

/// Copies an argument that is a vector or a span of vectors to types with Eigen's default alignment. Function
/// templates over Eigen::Matrix<S, N, 1> require these types.
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
    return result;  // by value, because a reference might refer to the copies
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

/// Whether a result owns its values. An unevaluated Eigen expression does not: it refers to temporaries that
/// were destroyed when the function returned.
template <class R>
inline constexpr bool kOwnsItsValues = [] {
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
      kOwnsItsValues<R>,
      "the error function returns an unevaluated Eigen expression, which refers to destroyed temporaries: "
      "give it a return type, or end it with .eval()");
  return call(e, std::forward<A>(a)...);
}

/// Row i of a result. The result may be a scalar.
template <class R>
decltype(auto) row(const R& result, int i) {
  if constexpr (requires { result.size(); }) {
    return result[static_cast<std::size_t>(i)];
  } else {
    return (result);
  }
}

/// Throws InvalidArgument, because an error function changed its number of rows.
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

/// The sum of the tangent sizes, or kDynamic if it is only known at run time.
template <class... V>
inline constexpr int kCols = [] {
  int sum = 0;
  bool dynamic = false;
  ((kIsTail<V> || Manifold<ElementOf<V>>::kDim == kDynamic ? void(dynamic = true)
                                                           : void(sum += Manifold<ElementOf<V>>::kDim)),
   ...);
  return dynamic ? kDynamic : sum;
}();

/// Up to kDualLimit columns are differentiated in one pass. More columns need passes of kDualChunk columns.
inline constexpr int kDualLimit = 24;
inline constexpr int kDualChunk = 8;
template <class... V>
inline constexpr int kDualSize = (kCols<V...> != kDynamic && kCols<V...> <= kDualLimit && kCols<V...> > 0)
                                     ? kCols<V...>
                                     : kDualChunk;

template <class... V>
using DualFor = Dual<double, kDualSize<V...>>;

/// The scalar type of the rows of a result.
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

/// The return type of a call, found without compiling the call, because Eigen declares conversions between
/// vectors of different scalars that do not compile.
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

/// Whether the result of E has the scalar S if the arguments have it. (A function of plain Eigen vectors
/// seems to accept vectors of S, because Eigen declares a conversion, but the result has plain scalars.)
template <class E, class S, class... A>
concept Carries = Callable<E, A...> &&
    std::is_same_v<typename RowScalar<std::remove_cvref_t<typename UnevaluatedResult<E, A...>::Type>>::Type,
                   S>;

template <class E, class S, class... V>
concept DifferentiableWith =
    (LiftableManifold<ElementOf<V>, S> && ...) && Carries<E, S, Argument<Lifted<V, S>>...>;

/// E requests numeric Jacobians (see Numeric).
template <class E>
concept WantsNumeric = requires {
  requires E::kNumeric;
};

/// Whether E declares `static constexpr bool kRigid = true`. Such an error measures the position of one
/// vertex completely, in the frame of another vertex or in the world. Therefore, the error changes if some of
/// its vertices are rotated, shifted or scaled. Only a rigid motion of all of its vertices may leave the
/// error unchanged, so the search for gauge freedom can skip the edge.
template <class E>
inline constexpr bool kIsRigid = [] {
  if constexpr (requires { E::kRigid; }) {
    return static_cast<bool>(E::kRigid);
  } else {
    return false;
  }
}();

/// Whether exact Jacobians are available.
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

/// The columns of the Jacobian that belong to one argument.
template <class V, int Rows>
using JacobianBlock = Eigen::Map<Matrix<double, Rows, kIsTail<V> ? kDynamic : Manifold<ElementOf<V>>::kDim>>;

template <class E, class... V>
inline constexpr bool kAnalytic = requires(const E& e, Argument<V>... x,
                                           JacobianBlock<V, kRows<Result<E, V...>>>... J) {
  e.jacobians(x..., J...);
};

/// The Jacobians that optimize() uses, unless Options::numeric_jacobians is set.
template <class E, class... V>
inline constexpr JacobianSource kJacobianSource = kAnalytic<E, V...>         ? JacobianSource::kAnalytic
                                                  : kDifferentiable<E, V...> ? JacobianSource::kAutomatic
                                                                             : JacobianSource::kNumeric;

/// E is an error function of the vertex types V... (each is a T; the last ones may be a Tail<T>).
template <class E, class... V>
concept EdgeType = std::copy_constructible<E> && sizeof...(V) > 0 && Callable<E, Argument<V>...>;

}  // namespace boxplus::detail
