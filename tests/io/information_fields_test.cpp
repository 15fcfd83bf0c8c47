// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/information_fields.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace boxplus
