// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/make_robust_kernel.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string message_of(const std::string& name, double delta) {
  try {
    make_robust_kernel(name, delta);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "no error";
}

TEST(MakeRobustKernel, ListsItsNames) {
  EXPECT_THAT(robust_kernel_names(), ElementsAre("Barron:ALPHA", "Cauchy", "DCS", "Fair", "GemanMcClure",
                                                 "Huber", "PseudoHuber", "Saturated", "Tukey", "Welsch"));
}

TEST(MakeRobustKernel, MakesTheKernelOfThatNameAndWidth) {
  const auto kernel = make_robust_kernel("Tukey", 4.5);
  EXPECT_EQ(kernel->name(), "Tukey");
  EXPECT_EQ(kernel->delta(), 4.5);
  EXPECT_EQ(make_robust_kernel("Barron:-inf", 2)->name(), "Barron");
}

TEST(MakeRobustKernel, NamesTheKnownKernelsWhenOneIsUnknown) {
  EXPECT_THAT(message_of("huber", 1),
              HasSubstr("unknown robust kernel 'huber'; known are Barron:ALPHA Cauchy"));
}

TEST(MakeRobustKernel, RefusesBadWidthsAndShapes) {
  EXPECT_THAT(message_of("Huber", 0), HasSubstr("expected a finite width > 0"));
  EXPECT_THAT(message_of("Huber", -1), HasSubstr("got -1"));
  EXPECT_THAT(message_of("DCS", std::numeric_limits<double>::quiet_NaN()), HasSubstr("robust kernel DCS"));
  EXPECT_THAT(message_of("Barron:", 1), HasSubstr("expected a number as shape"));
  EXPECT_THAT(message_of("Barron:1x", 1), HasSubstr("got '1x'"));
}

}  // namespace
}  // namespace boxplus
