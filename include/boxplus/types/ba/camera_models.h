// SPDX-License-Identifier: BSD-3-Clause
// The camera models: BAL's, and those of COLMAP, with COLMAP's names and order of parameters (cameras.txt).
//
// To add a model, write a struct like these, and use BasicCamera<YourModel>. If it shall be part of boxplus,
// add its camera to CameraList at the end of this file. SIMD kernels, file formats and tests then have it.
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include "boxplus/types/ba/camera.h"

namespace boxplus {

namespace detail {

template <class Distorted, int kForward = 1>
using PlaneLens = Lens<PlaneMapping, Distorted, kForward>;
template <class Distorted>
using FisheyeLens = Lens<FisheyeMapping, Distorted>;

/// f for both axes.
struct OneFocalLength {
  static constexpr int kFocalLengths = 1;
  static constexpr bool kHasCenter = true;
};
/// fx and fy.
struct TwoFocalLengths {
  static constexpr int kFocalLengths = 2;
  static constexpr bool kHasCenter = true;
};

template <class... Text>
constexpr std::array<std::string_view, sizeof...(Text)> names(const Text&... text) {
  return {text...};
}

// The models. kColmapId is COLMAP's number of a model, which its binary files contain (src/io/colmap).

/// "Bundle adjustment in the large" (Agarwal, Snavely, Seitz and Szeliski, 2010): the camera of Bundler
/// (Snavely), which looks along −z. The center of the image is 0.
struct BalModel {
  static constexpr std::string_view kName = "BAL";
  static constexpr auto kParameters = names("f", "k1", "k2");
  static constexpr int kFocalLengths = 1;
  static constexpr bool kHasCenter = false;
  using Lens = PlaneLens<Distortion<Terms<0, 1>>, -1>;
};

struct SimplePinholeModel : OneFocalLength {
  static constexpr std::string_view kName = "SIMPLE_PINHOLE";
  static constexpr int kColmapId = 0;
  static constexpr auto kParameters = names("f", "cx", "cy");
  using Lens = PlaneLens<Distortion<Terms<>>>;
};

struct PinholeModel : TwoFocalLengths {
  static constexpr std::string_view kName = "PINHOLE";
  static constexpr int kColmapId = 1;
  static constexpr auto kParameters = names("fx", "fy", "cx", "cy");
  using Lens = PlaneLens<Distortion<Terms<>>>;
};

struct SimpleRadialModel : OneFocalLength {
  static constexpr std::string_view kName = "SIMPLE_RADIAL";
  static constexpr int kColmapId = 2;
  static constexpr auto kParameters = names("f", "cx", "cy", "k");
  using Lens = PlaneLens<Distortion<Terms<0>>>;
};

struct RadialModel : OneFocalLength {
  static constexpr std::string_view kName = "RADIAL";
  static constexpr int kColmapId = 3;
  static constexpr auto kParameters = names("f", "cx", "cy", "k1", "k2");
  using Lens = PlaneLens<Distortion<Terms<0, 1>>>;
};

struct OpenCvModel : TwoFocalLengths {
  static constexpr std::string_view kName = "OPENCV";
  static constexpr int kColmapId = 4;
  static constexpr auto kParameters = names("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2");
  using Lens = PlaneLens<Distortion<Terms<0, 1>, Terms<>, 2>>;
};

/// Kannala and Brandt, "A generic camera model and calibration method" (2006), without its asymmetric terms.
struct OpenCvFisheyeModel : TwoFocalLengths {
  static constexpr std::string_view kName = "OPENCV_FISHEYE";
  static constexpr int kColmapId = 5;
  static constexpr auto kParameters = names("fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4");
  using Lens = FisheyeLens<Distortion<Terms<0, 1, 2, 3>>>;
};

struct FullOpenCvModel : TwoFocalLengths {
  static constexpr std::string_view kName = "FULL_OPENCV";
  static constexpr int kColmapId = 6;
  static constexpr auto kParameters =
      names("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6");
  using Lens = PlaneLens<Distortion<Terms<0, 1, 4>, Terms<5, 6, 7>, 2>>;
};

struct SimpleRadialFisheyeModel : OneFocalLength {
  static constexpr std::string_view kName = "SIMPLE_RADIAL_FISHEYE";
  static constexpr int kColmapId = 8;
  static constexpr auto kParameters = names("f", "cx", "cy", "k");
  using Lens = FisheyeLens<Distortion<Terms<0>>>;
};

struct RadialFisheyeModel : OneFocalLength {
  static constexpr std::string_view kName = "RADIAL_FISHEYE";
  static constexpr int kColmapId = 9;
  static constexpr auto kParameters = names("f", "cx", "cy", "k1", "k2");
  using Lens = FisheyeLens<Distortion<Terms<0, 1>>>;
};

/// ω in radians.
struct FovModel : TwoFocalLengths {
  static constexpr std::string_view kName = "FOV";
  static constexpr int kColmapId = 7;
  static constexpr auto kParameters = names("fx", "fy", "cx", "cy", "omega");
  using Lens = detail::Lens<FovMapping, Distortion<Terms<>>>;
};

struct ThinPrismFisheyeModel : TwoFocalLengths {
  static constexpr std::string_view kName = "THIN_PRISM_FISHEYE";
  static constexpr int kColmapId = 10;
  static constexpr auto kParameters =
      names("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "sx1", "sy1");
  using Lens = FisheyeLens<Distortion<Terms<0, 1, 4, 5>, Terms<>, 2, 6>>;
};

/// The camera of Engel et al., "Project Aria: a new tool for egocentric multi-modal AI research" (2023).
struct RadTanThinPrismFisheyeModel : TwoFocalLengths {
  static constexpr std::string_view kName = "RAD_TAN_THIN_PRISM_FISHEYE";
  static constexpr int kColmapId = 11;
  static constexpr auto kParameters =
      names("fx", "fy", "cx", "cy", "k0", "k1", "k2", "k3", "k4", "k5", "p0", "p1", "s0", "s1", "s2", "s3");
  using Lens = FisheyeLens<Composition<Distortion<Terms<0, 1, 2, 3, 4, 5>>, DecenteredPrism>>;
};

struct SimpleDivisionModel : OneFocalLength {
  static constexpr std::string_view kName = "SIMPLE_DIVISION";
  static constexpr int kColmapId = 12;
  static constexpr auto kParameters = names("f", "cx", "cy", "k");
  using Lens = detail::Lens<DivisionMapping, Distortion<Terms<>>>;
};

struct DivisionModel : TwoFocalLengths {
  static constexpr std::string_view kName = "DIVISION";
  static constexpr int kColmapId = 13;
  static constexpr auto kParameters = names("fx", "fy", "cx", "cy", "k");
  using Lens = detail::Lens<DivisionMapping, Distortion<Terms<>>>;
};

struct SimpleFisheyeModel : OneFocalLength {
  static constexpr std::string_view kName = "SIMPLE_FISHEYE";
  static constexpr int kColmapId = 14;
  static constexpr auto kParameters = names("f", "cx", "cy");
  using Lens = FisheyeLens<Distortion<Terms<>>>;
};

struct FisheyeModel : TwoFocalLengths {
  static constexpr std::string_view kName = "FISHEYE";
  static constexpr int kColmapId = 15;
  static constexpr auto kParameters = names("fx", "fy", "cx", "cy");
  using Lens = FisheyeLens<Distortion<Terms<>>>;
};

struct EucmModel : TwoFocalLengths {
  static constexpr std::string_view kName = "EUCM";
  static constexpr int kColmapId = 16;
  static constexpr auto kParameters = names("fx", "fy", "cx", "cy", "alpha", "beta");
  using Lens = detail::Lens<EnhancedUnifiedMapping, Distortion<Terms<>>>;
};

}  // namespace detail

using BalCamera = BasicCamera<detail::BalModel>;
using SimplePinholeCamera = BasicCamera<detail::SimplePinholeModel>;
using PinholeCamera = BasicCamera<detail::PinholeModel>;
using SimpleRadialCamera = BasicCamera<detail::SimpleRadialModel>;
using RadialCamera = BasicCamera<detail::RadialModel>;
using OpenCvCamera = BasicCamera<detail::OpenCvModel>;
using OpenCvFisheyeCamera = BasicCamera<detail::OpenCvFisheyeModel>;
using FullOpenCvCamera = BasicCamera<detail::FullOpenCvModel>;
using SimpleRadialFisheyeCamera = BasicCamera<detail::SimpleRadialFisheyeModel>;
using RadialFisheyeCamera = BasicCamera<detail::RadialFisheyeModel>;
using FovCamera = BasicCamera<detail::FovModel>;
using ThinPrismFisheyeCamera = BasicCamera<detail::ThinPrismFisheyeModel>;
using RadTanThinPrismFisheyeCamera = BasicCamera<detail::RadTanThinPrismFisheyeModel>;
using SimpleDivisionCamera = BasicCamera<detail::SimpleDivisionModel>;
using DivisionCamera = BasicCamera<detail::DivisionModel>;
using SimpleFisheyeCamera = BasicCamera<detail::SimpleFisheyeModel>;
using FisheyeCamera = BasicCamera<detail::FisheyeModel>;
using EucmCamera = BasicCamera<detail::EucmModel>;

namespace detail {

template <class... Camera>
struct CameraTypes {
  /// Calls f.operator()<Camera>() for each type, in order.
  template <class F>
  static constexpr void for_each(F&& f) {
    (f.template operator()<Camera>(), ...);
  }

  /// The place of a type in the list, or −1.
  template <class Wanted>
  static constexpr int place_of() {
    int place = 0;
    const bool is_found = ((std::is_same_v<Wanted, Camera> || (++place, false)) || ...);
    return is_found ? place : -1;
  }
};

/// All cameras of boxplus.
using CameraList =
    CameraTypes<BalCamera, SimplePinholeCamera, PinholeCamera, SimpleRadialCamera, RadialCamera, OpenCvCamera,
                OpenCvFisheyeCamera, FullOpenCvCamera, FovCamera, SimpleRadialFisheyeCamera,
                RadialFisheyeCamera, ThinPrismFisheyeCamera, RadTanThinPrismFisheyeCamera,
                SimpleDivisionCamera, DivisionCamera, SimpleFisheyeCamera, FisheyeCamera, EucmCamera>;

}  // namespace detail

}  // namespace boxplus
