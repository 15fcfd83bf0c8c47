// SPDX-License-Identifier: BSD-3-Clause
// Lifts an estimate x to x ⊞ δ over dual numbers, at δ = 0.
//
// The general way evaluates ⊞ with dual numbers. Most of this work is spent on the zeros and ones of δ, so a
// manifold of fixed size may know the result: if Manifold<T> has a member
//
//     template <class S> static void lift(const T& x, const detail::Seed<S>& seed, Rebind<S>& y);
//
// it is called instead. Here y is cast<S>(x), or it was lifted with the same seed from any estimate. For each
// number of y, lift() calls seed.set(number, value, k, slopes): the value, and the derivatives
// by δ[k], δ[k + 1], … All other derivatives of y are zero already.
#pragma once

#include <array>
#include <concepts>
#include <vector>

#include "boxplus/autodiff/dual.h"
#include "boxplus/base/thread_scratch.h"
#include "boxplus/manifold/manifold.h"

namespace boxplus::detail {

/// The entries of δ as independent variables: δ[k] is the variable `offset + k` of the dual numbers S. If S
/// has no such variable, δ[k] is a constant.
template <class S>
struct Seed {
  static constexpr int kVariables = S::kSize;
  int offset = 0;

  /// Whether any of the entries 0 … dim − 1 is a variable.
  bool any(int dim) const { return offset < kVariables && offset + dim > 0; }
  /// The seed of the entries from k on.
  Seed from(int k) const { return {offset + k}; }

  /// y ← value + Σ slopes[i] · δ[k + i], if all other derivatives of y are zero.
  template <std::size_t N>
  void set(S& y, double value, int k, const double (&slopes)[N]) const {
    y.value = value;
    for (int i = 0; i < static_cast<int>(N); ++i) {
      const int variable = offset + k + i;
      if (variable >= 0 && variable < kVariables)
        y.derivative[static_cast<std::size_t>(variable)] = slopes[i];
    }
  }
};

/// Converts to exactly T, and to no base class of it.
template <class T>
struct Exactly {
  template <class U>
  requires std::same_as<U, T>
  operator const U&() const;
};

/// Manifold<T> has the member lift() for T itself. A lift() that it has inherited with the manifold of a base
/// class of T is not used, because Manifold<T> may have another ⊞.
template <class T, class S>
concept LiftsItself = Manifold<T>::kDim !=
                      kDynamic&& requires(const Exactly<T>& x, const Seed<S>& seed, Rebind<T, S>& y) {
  Manifold<T>::lift(x, seed, y);
};

/// x ⊞ δ at δ = 0. If no entry of δ is a variable, all numbers are constants.
template <class S, class T>
Rebind<T, S> lift(const T& x, const Seed<S>& seed) {
  Rebind<T, S> lifted = Manifold<T>::template cast<S>(x);
  const int dim = tangent_dim(x);
  if (!seed.any(dim)) return lifted;
  if constexpr (LiftsItself<T, S>) {
    Manifold<T>::lift(x, seed, lifted);
    return lifted;
  } else {
    const auto moved = [&](auto& delta) {
      for (int k = 0; k < dim; ++k) {
        delta[static_cast<std::size_t>(k)] = S(0.0);
        seed.set(delta[static_cast<std::size_t>(k)], 0.0, k, {1.0});
      }
      return Manifold<Rebind<T, S>>::oplus(lifted, delta.data());
    };
    if constexpr (Manifold<T>::kDim == kDynamic) {
      const BorrowedScratch<std::vector<S>, struct LiftedDelta> delta;
      delta->resize(static_cast<std::size_t>(dim));
      return moved(*delta);
    } else {
      std::array<S, static_cast<std::size_t>(Manifold<T>::kDim > 0 ? Manifold<T>::kDim : 1)> delta;
      return moved(delta);
    }
  }
}

/// y ← lift(x, seed). Here y was lifted with the same seed from another estimate.
template <class S, class T>
void lift_again(const T& x, const Seed<S>& seed, Rebind<T, S>& y) {
  if constexpr (LiftsItself<T, S>) {
    Manifold<T>::lift(x, seed, y);
  } else {
    y = lift(x, seed);
  }
}

}  // namespace boxplus::detail
