// SPDX-License-Identifier: BSD-3-Clause
// Cameras, and poses with cameras, as objects and as rows. To add a camera, write a row below; it must also
// be in CameraList (types/ba/camera_models.h).
#pragma once

#include <array>
#include <string_view>

#include "boxplus/types/ba.h"
#include "values.h"

namespace boxplus::python {

/// The name of the Python class: that of C++.
template <class Camera>
inline constexpr std::string_view kCameraName = {};
template <>
inline constexpr std::string_view kCameraName<BalCamera> = "BalCamera";
template <>
inline constexpr std::string_view kCameraName<SimplePinholeCamera> = "SimplePinholeCamera";
template <>
inline constexpr std::string_view kCameraName<PinholeCamera> = "PinholeCamera";
template <>
inline constexpr std::string_view kCameraName<SimpleRadialCamera> = "SimpleRadialCamera";
template <>
inline constexpr std::string_view kCameraName<RadialCamera> = "RadialCamera";
template <>
inline constexpr std::string_view kCameraName<OpenCvCamera> = "OpenCvCamera";
template <>
inline constexpr std::string_view kCameraName<OpenCvFisheyeCamera> = "OpenCvFisheyeCamera";
template <>
inline constexpr std::string_view kCameraName<FullOpenCvCamera> = "FullOpenCvCamera";
template <>
inline constexpr std::string_view kCameraName<FovCamera> = "FovCamera";
template <>
inline constexpr std::string_view kCameraName<SimpleRadialFisheyeCamera> = "SimpleRadialFisheyeCamera";
template <>
inline constexpr std::string_view kCameraName<RadialFisheyeCamera> = "RadialFisheyeCamera";
template <>
inline constexpr std::string_view kCameraName<ThinPrismFisheyeCamera> = "ThinPrismFisheyeCamera";
template <>
inline constexpr std::string_view kCameraName<RadTanThinPrismFisheyeCamera> = "RadTanThinPrismFisheyeCamera";
template <>
inline constexpr std::string_view kCameraName<SimpleDivisionCamera> = "SimpleDivisionCamera";
template <>
inline constexpr std::string_view kCameraName<DivisionCamera> = "DivisionCamera";
template <>
inline constexpr std::string_view kCameraName<SimpleFisheyeCamera> = "SimpleFisheyeCamera";
template <>
inline constexpr std::string_view kCameraName<FisheyeCamera> = "FisheyeCamera";
template <>
inline constexpr std::string_view kCameraName<EucmCamera> = "EucmCamera";

/// The names of the parameters, with spaces between them, as a constant.
template <class Model>
struct ParameterText {
  static constexpr std::size_t kSize = [] {
    std::size_t size = Model::kParameters.size() - 1;
    for (const std::string_view name : Model::kParameters) size += name.size();
    return size;
  }();
  static constexpr std::array<char, kSize> kCharacters = [] {
    std::array<char, kSize> text{};
    std::size_t i = 0;
    for (const std::string_view name : Model::kParameters) {
      if (i > 0) text[i++] = ' ';
      for (const char c : name) text[i++] = c;
    }
    return text;
  }();
  static constexpr std::string_view kValue{kCharacters.data(), kSize};
};

template <class Model>
struct Value<BasicCamera<Model>> : ClassValue<BasicCamera<Model>> {
  using Camera = BasicCamera<Model>;
  static constexpr std::string_view kName = kCameraName<Camera>, kLayout = ParameterText<Model>::kValue;
  static_assert(!kName.empty());
  static constexpr int kSize = Camera::kSize;
  static Camera from_row(const double* row, RowName) {
    return Camera(Eigen::Map<const Vector<double, kSize>>(row));
  }
  template <class S>
  static void to_row(const BasicCamera<Model, S>& x, S* row) {
    std::copy_n(x.parameters.data(), kSize, row);
  }
};

}  // namespace boxplus::python
