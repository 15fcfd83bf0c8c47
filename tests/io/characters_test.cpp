// SPDX-License-Identifier: BSD-3-Clause
#include "io/characters.h"

#include <gtest/gtest.h>

#include <string>

namespace boxplus {
namespace {

TEST(Characters, AreQuotedUnchangedIfATerminalCanShowThem) {
  EXPECT_EQ(in_quotes("VERTEX_SE2"), "'VERTEX_SE2'");
  EXPECT_EQ(in_quotes("Größe €😀"), "'Größe €😀'");
  EXPECT_EQ(in_quotes(""), "the end of the line");
}

TEST(Characters, AreEscapedIfTheyAreControlCharactersOrNotUtf8) {
  EXPECT_EQ(in_quotes("a\x1b[31mb\x7f"), "'a\\x1b[31mb\\x7f'");
  EXPECT_EQ(in_quotes("\xff\xfe x"), "'\\xff\\xfe x'");
  EXPECT_EQ(in_quotes("\xc2\x9b"), "'\\xc2\\x9b'") << "a C1 control character";
  EXPECT_EQ(in_quotes("\xc0\xaf"), "'\\xc0\\xaf'") << "an overlong form";
  EXPECT_EQ(in_quotes("\xed\xa0\x80"), "'\\xed\\xa0\\x80'") << "a surrogate";
  EXPECT_EQ(in_quotes("x\xe2\x82"), "'x\\xe2\\x82'") << "a character that is cut off";
}

TEST(Characters, OfSeveralBytesAreNotCutIfALongTextIsShortened) {
  EXPECT_EQ(boxplus::in_quotes(std::string(39, 'a') + "€"), "'" + std::string(39, 'a') + "…'");
}

}  // namespace
}  // namespace boxplus
