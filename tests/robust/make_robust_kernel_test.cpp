// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/make_robust_kernel.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/kernel_table.h"

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

TEST(MakeRobustKernel, KnowsAllKernelsInAlphabeticalOrder) {
  std::vector<std::string_view> names;
  for (const detail::KernelEntry& kernel : detail::kernel_table()) names.push_back(kernel.name);
  EXPECT_THAT(names, ElementsAre("Barron:ALPHA", "Cauchy", "DCS", "Fair", "GemanMcClure", "Huber",
                                 "PseudoHuber", "Saturated", "Tukey", "Welsch"));
}

TEST(MakeRobustKernel, MakesTheKernelWithTheGivenNameAndWidth) {
  const auto kernel = make_robust_kernel("Tukey", 4.5);
  EXPECT_EQ(kernel->name(), "Tukey");
  EXPECT_EQ(kernel->delta(), 4.5);
  EXPECT_EQ(make_robust_kernel("Barron:-inf", 2)->name(), "Barron");
}

TEST(MakeRobustKernel, ListsTheKnownKernelsIfTheNameIsUnknown) {
  EXPECT_THAT(message_of("huber", 1),
              HasSubstr("unknown robust kernel 'huber'; known kernels: Barron:ALPHA, Cauchy"));
}

TEST(MakeRobustKernel, AcceptsAParameterOnlyForKernelsThatHaveOne) {
  EXPECT_THAT(message_of("Barron", 1), HasSubstr("unknown robust kernel 'Barron'"));
  EXPECT_THAT(message_of("Huber:1", 1), HasSubstr("unknown robust kernel 'Huber:1'"));
}

TEST(MakeRobustKernel, RefusesBadWidthsAndShapes) {
  EXPECT_THAT(message_of("Huber", 0), HasSubstr("expected a finite width > 0"));
  EXPECT_THAT(message_of("Huber", -1), HasSubstr("got -1"));
  EXPECT_THAT(message_of("Tukey", 1e-300), HasSubstr("expected a width from 1e-100 to 1e100, got 1e-300"));
  EXPECT_THAT(message_of("Barron:1", 1e200), HasSubstr("Barron: expected a width from 1e-100 to 1e100"));
  EXPECT_THAT(message_of("DCS", std::numeric_limits<double>::quiet_NaN()), HasSubstr("robust kernel DCS"));
  EXPECT_THAT(message_of("Barron:", 1), HasSubstr("expected a number as shape"));
  EXPECT_THAT(message_of("Barron:1x", 1), HasSubstr("got '1x'"));
}

TEST(MakeDefaultKernel, HasAWidthThatIsAboveNinetyFivePercentOfTheInliers) {
  EXPECT_NEAR(make_default_kernel("Huber", 1)->delta(), 1.959964, 1e-6);
  EXPECT_NEAR(make_default_kernel("Cauchy", 6)->delta(), std::sqrt(12.591587), 1e-6);
  EXPECT_NEAR(make_default_kernel("Barron:-2", 3)->delta(), std::sqrt(7.814728), 1e-6);
}

TEST(MakeDefaultKernel, SquaresTheWidthOfKernelsWhoseWidthIsASquaredError) {
  // Like Huber, DCS begins to reduce weights at the 95 % quantile of chi2.
  for (const int rows : {1, 3, 6}) {
    const double e2 = chi2_quantile(rows, 0.95);
    for (const char* name : {"Huber", "DCS"}) {
      const auto kernel = make_default_kernel(name, rows);
      EXPECT_EQ((*kernel)(0.999 * e2).first, 1) << name;
      EXPECT_LT((*kernel)(1.001 * e2).first, 1) << name;
    }
    EXPECT_NEAR((*make_default_kernel("GemanMcClure", rows))(e2).first, 0.25, 1e-12);
  }
}

TEST(MakeDefaultKernel, RefusesUnknownNamesAndErrorsWithoutRows) {
  EXPECT_THROW(make_default_kernel("Hubert", 3), InvalidArgument);
  EXPECT_THROW(make_default_kernel("Huber", 0), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
