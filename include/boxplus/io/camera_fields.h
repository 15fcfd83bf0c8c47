// SPDX-License-Identifier: BSD-3-Clause
// The representation of cameras in a file (io/file_fields.h).
#pragma once

#include "boxplus/io/file_fields.h"
#include "boxplus/manifold/product.h"
#include "boxplus/types/ba/camera_models.h"

namespace boxplus {

/// The parameters in the order of Model::kParameters.
template <class Model>
struct FileFields<BasicCamera<Model>> {
  static BasicCamera<Model> read(FieldReader& in) {
    BasicCamera<Model> camera;
    in.numbers(camera.parameters.data(), BasicCamera<Model>::kSize, "a parameter of the camera");
    return camera;
  }
  static void write(const BasicCamera<Model>& camera, FieldWriter& out) {
    for (int i = 0; i < BasicCamera<Model>::kSize; ++i) out.number(camera.parameters[i]);
  }
};

/// The pose as that of SE3, then f k1 k2.
template <>
struct FileFields<Product<SE3, BalCamera>> {
  static Product<SE3, BalCamera> read(FieldReader& in) {
    const SE3 pose = FileFields<SE3>::read(in);
    return Product<SE3, BalCamera>(pose, FileFields<BalCamera>::read(in));
  }
  static void write(const Product<SE3, BalCamera>& x, FieldWriter& out) {
    FileFields<SE3>::write(x.get<0>(), out);
    FileFields<BalCamera>::write(x.get<1>(), out);
  }
};

}  // namespace boxplus
