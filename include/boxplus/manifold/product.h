// SPDX-License-Identifier: BSD-3-Clause
// Products of manifolds: a vertex with several parts, such as a pose with a velocity and a bias.
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include "boxplus/manifold/lift.h"
#include "boxplus/manifold/manifold.h"

namespace boxplus {

/// A value that consists of several parts. Its tangent consists of the tangents of the parts, in the same
/// order. Parts whose size is chosen at run time are allowed. `auto& [pose, velocity] = product;` works, as
/// does product.get<0>().
template <class... Parts>
struct Product {
  std::tuple<Parts...> parts;

  Product() = default;
  explicit Product(const Parts&... values) requires(sizeof...(Parts) > 0) : parts(values...) {}

  template <std::size_t I>
  auto& get() {
    return std::get<I>(parts);
  }
  template <std::size_t I>
  const auto& get() const {
    return std::get<I>(parts);
  }
};

template <class... Parts>
struct Manifold<Product<Parts...>> {
  using Point = Product<Parts...>;
  // conditional_t makes the look-up of each part's Rebind depend on T.
  template <class T>
  using Rebind = Product<detail::Rebind<std::conditional_t<false, T, Parts>, T>...>;
  static constexpr int kDim =
      ((Manifold<Parts>::kDim == kDynamic) || ...) ? kDynamic : (0 + ... + Manifold<Parts>::kDim);

  static int dim(const Point& x) {
    return std::apply([](const Parts&... part) { return (0 + ... + tangent_size(part)); }, x.parts);
  }

  template <class D>
  static auto oplus(const Point& x, const D* delta) {
    const auto part_oplus = [&delta]<class Part>(const Part& part) {
      const D* mine = delta;
      delta += tangent_size(part);
      return Manifold<Part>::oplus(part, mine);
    };
    return std::apply(
        [&](const Parts&... part) {
          // part_oplus() advances `delta`, so the order of the calls matters. Inside braces, it is from left
          // to right.
          return from_tuple(std::tuple<std::decay_t<decltype(part_oplus(part))>...>{part_oplus(part)...});
        },
        x.parts);
  }

  template <class D>
  static void ominus(const Point& y, const Point& x, D* delta) {
    const auto part_ominus = [&delta]<class Part>(const Part& part_y, const Part& part_x) {
      Manifold<Part>::ominus(part_y, part_x, delta);
      delta += tangent_size(part_x);
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (part_ominus(std::get<I>(y.parts), std::get<I>(x.parts)), ...);
    }
    (std::index_sequence_for<Parts...>{});
  }

  template <class T>
  static Rebind<T> cast(const Point& x) {
    return std::apply(
        [](const Parts&... part) { return Rebind<T>(Manifold<Parts>::template cast<T>(part)...); }, x.parts);
  }

  template <class T>
  static void lift(const Point& x, const detail::Seed<T>& seed, Rebind<T>& y) {
    int k = 0;
    const auto part_lift = [&]<class Part>(const Part& part, auto& lifted) {
      detail::lift_again(part, seed.from(k), lifted);
      k += tangent_size(part);
    };
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (part_lift(std::get<I>(x.parts), std::get<I>(y.parts)), ...);
    }
    (std::index_sequence_for<Parts...>{});
  }

  static double* entry(Point& x, int i) requires(detail::ManifoldType<Parts>&&...) {
    double* result = nullptr;
    const auto look_in = [&]<class Part>(Part& part) {
      const int size = tangent_size(part);
      if (i >= 0 && i < size) result = detail::entry(part, i);
      i -= size;
    };
    std::apply([&](Parts&... part) { (look_in(part), ...); }, x.parts);
    return result;
  }

 private:
  /// Like tangent_dim(), but also accepts parts that are lifted to another scalar.
  template <class Part>
  static int tangent_size(const Part& part) {
    if constexpr (Manifold<Part>::kDim == kDynamic) {
      return Manifold<Part>::dim(part);
    } else {
      return Manifold<Part>::kDim;
    }
  }
  template <class... Results>
  static Product<Results...> from_tuple(std::tuple<Results...>&& results) {
    Product<Results...> product;
    product.parts = std::move(results);
    return product;
  }
};

}  // namespace boxplus

template <class... Parts>
struct std::tuple_size<boxplus::Product<Parts...>> : std::tuple_size<std::tuple<Parts...>> {};
template <std::size_t I, class... Parts>
struct std::tuple_element<I, boxplus::Product<Parts...>> : std::tuple_element<I, std::tuple<Parts...>> {};
