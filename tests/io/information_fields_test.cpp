// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/information_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

TEST(InformationFields, AreTheRowsOfTheUpperTriangle) {
  FieldReader in("g", 1, "4 1 0 3 0.5 2");
  const Information omega = read_information(in, 3);
  const detail::InformationView view{omega.kind(), 3, omega.values().data()};
  EXPECT_EQ(view(0, 1), 1);
  EXPECT_EQ(view(2, 1), 0.5);
  std::string text;
  FieldWriter out(text);
  write_information(view, out);
  EXPECT_EQ(text, "4 1 0 3 0.5 2");
}

TEST(InformationFields, AreReportedWithTheirColumnIfTheMatrixIsIndefinite) {
  const std::vector<double> values{7, 1, 2, 1};
  const std::string line = "TAG 7 1 2 1";
  FieldReader text("g", 1, line), numbers("g", 1, line, {.values = values, .integers = 4});
  text.token("a tag");
  for (FieldReader in : {text, numbers}) {
    in.integer("an id");
    try {
      read_information(in, 2);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.column(), 7);
    }
  }
}

TEST(InformationFields, MayBeCheckedAfterTheyAreRead) {
  FieldReader in("g", 1, "1 2 1");
  const detail::UncheckedInformation omega = detail::read_unchecked_information(in, 2, nullptr);
  EXPECT_THROW(omega.check(in), InputError);
}

TEST(InformationFields, OfAnIndefiniteMatrixSayHowToGoOn) {
  FieldReader in("g", 1, "1 2 1");
  try {
    read_information(in, 2);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("--information project"));
  }
}

TEST(InformationFields, OfAnIndefiniteMatrixBecomeTheNearestPositiveSemidefiniteOne) {
  FieldReader in("g", 1, "1 2 1");  // the eigenvalues are 3 and −1
  in.set_policy(ReadOptions::Indefinite::kProject);
  const Information omega = read_information(in, 2);
  const detail::InformationView view{omega.kind(), 2, omega.values().data()};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(view(i, j), 1.5, 1e-14);
  }
  EXPECT_TRUE(in.has_indefinite());
}

TEST(InformationFields, OfASemidefiniteMatrixAreNotProjected) {
  FieldReader in("g", 1, "4 2 1 1 1 0 -3 0 1");
  in.set_policy(ReadOptions::Indefinite::kProject);
  const Information omega = read_information(in, 2);  // singular
  EXPECT_EQ(std::vector<double>(omega.values().begin(), omega.values().end()),
            (std::vector<double>{4, 2, 1}));
  EXPECT_FALSE(in.has_indefinite());
}

TEST(InformationFields, OfAMatrixWithoutAPositiveEigenvalueAreRefused) {
  FieldReader in("g", 1, "-1 0 -2");
  in.set_policy(ReadOptions::Indefinite::kProject);
  EXPECT_THROW(read_information(in, 2), InputError);
}

TEST(InformationFields, OfAnIndefiniteMatrixAreKeptAsGivenIfWanted) {
  FieldReader in("g", 1, "1 2 1");
  in.set_policy(ReadOptions::Indefinite::kAsGiven);
  const Information omega = read_information(in, 2);
  EXPECT_EQ(std::vector<double>(omega.values().begin(), omega.values().end()),
            (std::vector<double>{1, 2, 1}));
  EXPECT_EQ(omega.complaint(2), "");
  EXPECT_TRUE(in.has_indefinite());
}

/// The nearest matrix: no positive semi-definite matrix in its neighborhood is nearer.
TEST(InformationFields, AreProjectedOnTheNearestMatrix) {
  const std::string line = "5 1 -3 0 2 1 4 0.5 -1 2";
  FieldReader listed("g", 1, line), projected("g", 1, line);
  Eigen::Matrix4d given;
  for (int i = 0; i < 4; ++i) {
    for (int j = i; j < 4; ++j) given(i, j) = given(j, i) = listed.number("");
  }
  projected.set_policy(ReadOptions::Indefinite::kProject);
  const Information omega = read_information(projected, 4);
  const Eigen::Matrix4d nearest = detail::InformationView{omega.kind(), 4, omega.values().data()}.matrix();
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(nearest).eigenvalues()[0], -1e-12);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Matrix4d noise = Eigen::Matrix4d::NullaryExpr([&] { return normal(random); });
    const double share = std::pow(10, -1 - k % 4);
    const Eigen::Matrix4d other = (1 - share) * nearest + share * noise * noise.transpose();
    EXPECT_GE((other - given).norm(), (nearest - given).norm() - 1e-12);
  }
}

}  // namespace
}  // namespace boxplus
