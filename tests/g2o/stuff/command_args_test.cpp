// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/command_args.h"

#include <gtest/gtest.h>

namespace {

/// A subclass that reads and sets parameters as text.
class TextArgs : public g2o::CommandArgs {
 public:
  std::string text(size_t i) const { return std::string(type2str(_args[i].type)) + ": " + arg2str(_args[i]); }
  void set(size_t i, const std::string& text) { str2arg(text, _args[i]); }
};

TEST(CommandArgs, CanBeReadAndSetAsTextBySubclasses) {
  TextArgs args;
  int iterations = 0;
  bool verbose = false;
  std::vector<int> ids;
  args.param("i", iterations, 5, "iterations");
  args.param("v", verbose, false, "verbose");
  args.param("ids", ids, {1, 2}, "ids");
  EXPECT_EQ(args.text(0), "<int>: 5");
  EXPECT_EQ(args.text(1), "<bool>: 0");
  EXPECT_EQ(args.text(2), "<vector_int>: 1,2");
  args.set(0, "7");
  args.set(1, "1");
  args.set(2, "3;4");
  EXPECT_EQ(iterations, 7);
  EXPECT_TRUE(verbose);
  EXPECT_EQ(ids, std::vector<int>({3, 4}));
  args.set(0, "eight");
  EXPECT_EQ(args.text(0), "<int>: 7");
}

TEST(CommandArgs, ReadFlagsValuesAndPositionalArguments) {
  g2o::CommandArgs args;
  bool verbose = false;
  int iterations = 0;
  std::vector<double> gains;
  std::string file;
  args.param("v", verbose, false, "verbose");
  args.param("i", iterations, 5, "iterations");
  args.param("gains", gains, {}, "gains");
  args.paramLeftOver("file", file, "", "input");
  EXPECT_TRUE(args.parseArgs({"-v", "-i", "7", "-gains", "1;2.5", "graph.g2o"}, false));
  EXPECT_TRUE(verbose);
  EXPECT_EQ(iterations, 7);
  EXPECT_EQ(gains, std::vector<double>({1, 2.5}));
  EXPECT_EQ(file, "graph.g2o");
  EXPECT_FALSE(args.parseArgs({"-i", "seven", "graph.g2o"}, false));
  EXPECT_EQ(args.error(), "parameter -i: expected an integer, got 'seven'");
}

}  // namespace
