// SPDX-License-Identifier: BSD-3-Clause
// A fixture for tests that run once with the kernels of each instruction set that this processor supports.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "kernels/kernel_table.h"

namespace boxplus {

class EveryIsa : public ::testing::TestWithParam<const dense::KernelTable*> {
 protected:
  void SetUp() override { dense::use_kernels(*GetParam()); }
  void TearDown() override { dense::use_kernels(*before_); }

 private:
  const dense::KernelTable* before_ = &dense::kernels();
};

inline std::string name_of_isa(const ::testing::TestParamInfo<const dense::KernelTable*>& test) {
  return test.param->name;
}

}  // namespace boxplus
