// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/file_format.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

TEST(FileFormats, AreFoundByNameAndByExtension) {
  const FileFormats& formats = default_formats();
  EXPECT_EQ(formats.find("TORO"), formats.of_path("data/w10000.graph"));
  EXPECT_EQ(formats.find("g2o"), formats.of_path("a.graph.g2o"));
  EXPECT_EQ(formats.find("toro"), nullptr);
  EXPECT_EQ(formats.of_path("graph"), nullptr);
}

TEST(FileFormats, TryTheFormatThatWasAddedLastFirst) {
  FileFormats formats = default_formats();
  EXPECT_EQ(formats.recognize("any text")->name, "g2o");
  formats.add({.name = "mine",
               .extension = ".mine",
               .recognize = [](std::string_view) { return true; },
               .read = formats.find("g2o")->read});
  EXPECT_EQ(formats.recognize("any text")->name, "mine");
  EXPECT_EQ(default_formats().find("mine"), nullptr) << "only a copy of the default formats was changed";
}

TEST(FileFormats, RefuseAFormatWithoutFunctionsOrWithATakenNameOrExtension) {
  const auto complaint = [](const char* name, const char* extension) -> std::string {
    FileFormats formats = default_formats();
    FileFormat format = *formats.find("g2o");
    format.name = name;
    format.extension = extension;
    try {
      formats.add(format);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "no complaint";
  };
  EXPECT_EQ(complaint("mine", ".mine"), "no complaint");
  EXPECT_THAT(complaint("mine", ".graph"), HasSubstr("TORO's .graph is already registered"));
  EXPECT_THAT(complaint("TORO", ".mine"), HasSubstr("TORO's .graph is already registered"));
  EXPECT_THAT(complaint("", ".mine"), HasSubstr("expected a name"));
  FileFormats formats;
  EXPECT_THROW(formats.add({.name = "mine", .extension = ".mine", .recognize = {}, .read = {}}),
               InvalidArgument);
}

}  // namespace
}  // namespace boxplus
