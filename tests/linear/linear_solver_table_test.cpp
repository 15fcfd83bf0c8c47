// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linear/linear_solver_table.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

TEST(LinearSolverTable, HasOneNameAndOneSolverForEachKind) {
  std::set<std::string_view> names;
  for (const detail::LinearSolverEntry& entry : detail::linear_solver_table()) {
    EXPECT_EQ(to_string(entry.kind), entry.name);
    EXPECT_NE(make_linear_solver(entry.kind), nullptr);
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
  }
  EXPECT_THROW((void)make_linear_solver(static_cast<LinearSolverKind>(99)), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
