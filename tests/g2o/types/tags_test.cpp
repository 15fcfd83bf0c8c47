// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/factory.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/stuff/logger.h"

G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_TYPE_GROUP(slam2d_segment);
G2O_USE_TYPE_GROUP(sclam);
G2O_USE_TYPE_GROUP(slam3d);
G2O_USE_TYPE_GROUP(slam3d_addons);
G2O_USE_TYPE_GROUP(sba);
G2O_USE_TYPE_GROUP(expmap);
G2O_USE_TYPE_GROUP(sim3);
G2O_USE_TYPE_GROUP(icp);
G2O_USE_TYPE_GROUP(data);

namespace {

/// Unregisters each tag and loads a line with this tag. Returns the tags whose libraries load() does not
/// name.
std::string tags_without_library() {
  std::string without;
  std::string said;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& text) { said = text; });
  std::vector<std::string> tags;
  g2o::Factory::instance()->fillKnownTypes(tags);
  if (tags.size() < 50) return "expected all types of the g2o API";
  for (const std::string& tag : tags) {
    g2o::Factory::instance()->unregisterType(tag);
    g2o::SparseOptimizer optimizer;
    std::istringstream file(tag + " 1 2 3\n");
    optimizer.load(file);
    if (said.find("1 line is skipped; link libg2o_types_") == std::string::npos) without += tag + ' ';
    said.clear();
  }
  return without;
}

TEST(Tags, TheLibraryOfEveryTypeIsNamedIfItsTagIsUnknown) {
  const auto check = [] {
    const std::string without = tags_without_library();
    std::cerr << without;
    _exit(without.empty() ? 0 : 1);
  };
  EXPECT_EXIT(check(), testing::ExitedWithCode(0), "");  // in a process of its own, which loses its types
}

}  // namespace
