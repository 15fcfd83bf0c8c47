// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "boxplus/io/file_format.h"

namespace boxplus {
namespace {

TEST(DefaultFormats, BeginWithG2oAndHaveDifferentNamesAndLabels) {
  const auto& formats = default_formats().all();
  EXPECT_EQ(formats[0].label(), ".g2o");
  std::set<std::string> names, labels;
  for (const FileFormat& format : formats) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_TRUE(labels.insert(format.label()).second) << format.label();
    EXPECT_EQ(default_formats().find(format.name), &format);
  }
}

}  // namespace
}  // namespace boxplus
