// SPDX-License-Identifier: BSD-3-Clause
// Lenses: from a point in the frame of the camera to the normalized image (focal length 1, center at 0).
//
// Every mapping here is symmetric about the optical axis: the point (x, y, z), with z along the axis and
// q = x² + y², has the image s (x, y) with a scale s(q, z). Then the distortion is applied.
//   ∂(s x, s y)/∂(x, y) = s I + 2 s_q (x, y)(x, y)ᵀ,   ∂/∂z = s_z (x, y)ᵀ
#pragma once

#include <array>

#include "boxplus/types/ba/distortion.h"

namespace boxplus::detail {

/// s and its partial derivatives with respect to q, to z, and to the parameters of the mapping.
template <class S, int kParameters = 0>
struct ImageScale {
  S value, by_q, by_z;
  std::array<S, kParameters> by_parameters = {};
};

/// The pinhole: s = 1/z. It continues to negative z, where it mirrors the point in the center of the camera.
struct PlaneMapping {
  static constexpr int kSize = 0;

  template <class S>
  static ImageScale<S> scale(const S& /*q*/, const S& z, const S* /*k*/) {
    const Inverse<S> inverted = inverse(z);
    return {inverted.value, S(0.0), inverted.slope};
  }
  template <class S>
  static bool sees(const S& /*q*/, const S& z, const S* /*k*/) {
    return z > kSmallDivisor;
  }
};

/// The equidistant fisheye: s = θ/√q with the angle θ = atan2(√q, z) to the optical axis. The image of the
/// negative axis (θ = π) is a circle, so a point on that axis has no image; s is finite there, too.
struct FisheyeMapping {
  static constexpr int kSize = 0;

  template <class S>
  static ImageScale<S> scale(const S& q, const S& z, const S* /*k*/) {
    using std::atan2;
    using std::sqrt;
    // Near the axis, by the series θ/√q = 1/z − q/(3z³) + q²/(5z⁵) − …
    constexpr double kFront = 1e-10, kBack = 1e-24, kCenter = 1e-40;
    const auto is_near = q <= choose(z > 0.0, S(kFront), S(kBack)) * z * z + kCenter;
    const S square = choose(is_near, S(1.0), q), r = sqrt(square), s = atan2(r, z) / r;
    const S distance2 = square + z * z;
    const Inverse<S> g = inverse(z);
    const S g2 = g.value * g.value, x = q * g2;
    return {choose(is_near, S(g.value * (1.0 + x * (x * 0.2 - 1.0 / 3.0))), s),
            choose(is_near, S(g.value * g2 * (0.4 * x - 1.0 / 3.0)), S((z / distance2 - s) / (2.0 * square))),
            choose(is_near, S(g.slope * (1.0 - x)), S(-1.0 / distance2))};
  }
  template <class S>
  static bool sees(const S& q, const S& z, const S* /*k*/) {
    return q > 0.0 || z > 0.0;
  }
};

/// The field-of-view model of Devernay and Faugeras, "Straight lines have to be straight" (2001), with one
/// parameter ω: the radius is atan(a √q/z)/ω with a = 2 tan(ω/2). So with the scale t of the fisheye,
/// s = (a/ω) t(a² q, z). ω = 0 is the pinhole.
struct FovMapping {
  static constexpr int kSize = 1;

  template <class S>
  static ImageScale<S, kSize> scale(const S& q, const S& z, const S* k) {
    using std::tan;
    const S omega = k[0], omega2 = omega * omega;
    const S a = 2.0 * tan(S(0.5 * omega)), a_slope = 1.0 + 0.25 * a * a;
    // a/ω and its derivative; near 0, by the series 1 + ω²/12 + ω⁴/120 + 17ω⁶/20160 + …
    const auto is_small = omega2 < 1e-4;
    const S divisor = choose(is_small, S(1.0), omega);
    const S ratio =
        choose(is_small, S(1.0 + omega2 * (1.0 / 12 + omega2 * (1.0 / 120 + omega2 * (17.0 / 20160)))),
               S(a / divisor));
    const S ratio_slope =
        choose(is_small, S(omega * (1.0 / 6 + omega2 * (1.0 / 30 + omega2 * (17.0 / 3360)))),
               S((a_slope - ratio) / divisor));
    const ImageScale<S> t = FisheyeMapping::scale(S(a * a * q), z, k);
    return {S(ratio * t.value),
            S(ratio * a * a * t.by_q),
            S(ratio * t.by_z),
            {S(ratio_slope * t.value + ratio * t.by_q * 2.0 * a * a_slope * q)}};
  }
  template <class S>
  static bool sees(const S& /*q*/, const S& z, const S* k) {
    constexpr double kHalfTurn = 3.14159265358979323846;
    return z > kSmallDivisor && k[0] > -kHalfTurn && k[0] < kHalfTurn;
  }
};

/// The enhanced unified camera model of Khomutenko, Garcia and Martinet, "An enhanced unified camera model"
/// (2016), with the parameters α from 0 to 1 and β > 0: s = 1/(α d + (1 − α) z) with d = √(β q + z²). α = 0
/// is the pinhole.
struct EnhancedUnifiedMapping {
  static constexpr int kSize = 2;

  template <class S>
  static ImageScale<S, kSize> scale(const S& q, const S& z, const S* k) {
    const S alpha = k[0], beta = k[1];
    const Root<S> d = root(S(beta * q + z * z));
    const Inverse<S> s = inverse(S(alpha * d.value + (1.0 - alpha) * z));
    return {s.value,
            S(s.slope * alpha * beta * d.slope),
            S(s.slope * (1.0 - alpha + 2.0 * alpha * z * d.slope)),
            {S(s.slope * (d.value - z)), S(s.slope * alpha * q * d.slope)}};
  }
  /// Farther from the axis, the denominator is not positive, or the radius of the image decreases again.
  template <class S>
  static bool sees(const S& q, const S& z, const S* k) {
    const S alpha = k[0], beta = k[1], d = root(S(beta * q + z * z)).value;
    return alpha >= 0.0 && alpha <= 1.0 && beta > 0.0 && alpha * d + (1.0 - alpha) * z > kSmallDivisor &&
           alpha * z + (1.0 - alpha) * d > 0.0;
  }
};

/// The division model of Fitzgibbon, "Simultaneous linear estimation of multiple view geometry and lens
/// distortion" (2001), with one parameter k: the image point d shows the ray (d, 1 + k |d|²). With the
/// discriminant D = z² − 4 k q, the solution that is the pinhole for k = 0 is d = s (x, y) with s = 2/(z +
/// √D). With k < 0, there are also rays behind the camera. If D < 0, there is no solution. Then s continues
/// to increase by the reflection of its graph at D = 0: s = 4/z − 2/(z + √−D).
struct DivisionMapping {
  static constexpr int kSize = 1;

  template <class S>
  static ImageScale<S, kSize> scale(const S& q, const S& z, const S* k) {
    const S D = z * z - 4.0 * k[0] * q;
    const auto is_negative = D < 0.0;
    const Root<S> signed_root = root(D);
    const S sign = choose(is_negative, S(-1.0), S(1.0));
    const Inverse<S> s = inverse(S(0.5 * (z + sign * signed_root.value)));
    const S by_z = sign * 0.5 * s.slope, by_D = 0.5 * s.slope * signed_root.slope;
    const Inverse<S> at_zero = inverse(S(0.5 * z));
    const S zero(0.0);
    return {S(sign * s.value + choose(is_negative, S(2.0 * at_zero.value), zero)),
            S(by_D * -4.0 * k[0]),
            S(by_z + by_D * 2.0 * z + choose(is_negative, at_zero.slope, zero)),
            {S(by_D * -4.0 * q)}};
  }
  template <class S>
  static bool sees(const S& q, const S& z, const S* k) {
    const S D = z * z - 4.0 * k[0] * q;
    return D > 0.0 && (k[0] < 0.0 || z > 0.0) && 0.5 * (z + root(D).value) > kSmallDivisor;
  }
};

/// A mapping and a distortion. The parameters k are those of the mapping, then those of the distortion. The
/// camera looks along the axis kForward z.
template <class Mapping, class Distorted, int kForward = 1>
struct Lens {
  static_assert(kForward == 1 || kForward == -1);
  static constexpr int kSize = Mapping::kSize + Distorted::kSize;

  /// image ← the image of p, J_p ← ∂image/∂p (2 × 3), J_k ← ∂image/∂k (2 × kSize).
  template <class S, class J>
  static void project(const S* p, const S* k, S* image, J J_p, J J_k) {
    const S q = p[0] * p[0] + p[1] * p[1];
    const ImageScale<S, Mapping::kSize> s = Mapping::scale(q, S(kForward * 1.0 * p[2]), k);
    const S u[2] = {s.value * p[0], s.value * p[1]};
    if constexpr (!kWanted<J>) {
      Distorted::apply(u, k + Mapping::kSize, image, nullptr, nullptr);
    } else {
      S J_u[4];
      Distorted::apply(u, k + Mapping::kSize, image, J_u, J_k + 2 * Mapping::kSize);
      const S twice = 2.0 * s.by_q, mixed = twice * p[0] * p[1];
      const S along_x = s.value + twice * p[0] * p[0], along_y = s.value + twice * p[1] * p[1];
      for (int i = 0; i < 2; ++i) {
        const S radial = J_u[i] * p[0] + J_u[2 + i] * p[1];
        J_p[i] = J_u[i] * along_x + J_u[2 + i] * mixed;
        J_p[2 + i] = J_u[i] * mixed + J_u[2 + i] * along_y;
        J_p[4 + i] = kForward * 1.0 * s.by_z * radial;
        for (int m = 0; m < Mapping::kSize; ++m)
          J_k[2 * m + i] = s.by_parameters[static_cast<std::size_t>(m)] * radial;
      }
    }
  }

  template <class S>
  static bool sees(const S* p, const S* k) {
    const S q = p[0] * p[0] + p[1] * p[1], z = kForward * 1.0 * p[2];
    if (!Mapping::sees(q, z, k)) return false;
    const S s = Mapping::scale(q, z, k).value;
    const S u[2] = {s * p[0], s * p[1]};
    return Distorted::is_defined(u, k + Mapping::kSize);
  }
};

}  // namespace boxplus::detail
