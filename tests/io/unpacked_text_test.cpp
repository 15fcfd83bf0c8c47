// SPDX-License-Identifier: BSD-3-Clause
#include "io/unpacked_text.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"
#include "io/packed.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Unpack, RefusesALongTextOfAMuchSmallerFile) {
  const std::string lines(1'000'000, '\n'), bytes = packed(lines);
  const UnpackLimits small{.small_size = 100'000};
  EXPECT_THAT([&] { unpack(bytes, "g.gz", small); },
              ThrowsMessage<FileError>(HasSubstr("g.gz: cannot be unpacked: expected a text that is at most "
                                                 "200 times as long as the packed file")));
  EXPECT_EQ(unpack(bytes, "g.gz", {.small_size = 1'000'000}).text, lines);
  EXPECT_EQ(unpack(bytes, "g.gz", {.small_size = 100'000, .ratio = 2000}).text, lines);
  EXPECT_EQ(unpack(bytes, "g.gz").text, lines);
}

TEST(Unpack, RefusesATextThatIsTooLong) {
  const std::string bytes = packed("0123456789");
  EXPECT_EQ(unpack(bytes, "g.gz", {.size = 10}).text, "0123456789");
  EXPECT_THAT([&] { unpack(bytes, "g.gz", {.size = 9}); },
              ThrowsMessage<FileError>("g.gz: cannot be unpacked: expected at most 9 bytes"));
}

}  // namespace
}  // namespace boxplus
