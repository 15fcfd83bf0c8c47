// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/property.h"

#include <gtest/gtest.h>

namespace {

/// A property that counts how many properties of this type were deleted.
class CountedProperty : public g2o::IntProperty {
 public:
  CountedProperty(const std::string& name, int value) : g2o::IntProperty(name, value) {}
  ~CountedProperty() override { ++deleted; }
  static inline int deleted = 0;
};

TEST(PropertyMap, DeletesThePropertiesThatItMakes) {
  CountedProperty::deleted = 0;
  {
    g2o::PropertyMap map;
    CountedProperty* made = map.makeProperty<CountedProperty>("width", 3);
    EXPECT_EQ(map.makeProperty<CountedProperty>("width", 7), made);
    EXPECT_EQ(map.getProperty<g2o::IntProperty>("width"), made);
    EXPECT_EQ(map.getProperty<g2o::DoubleProperty>("width"), nullptr);
    EXPECT_EQ(map.makeProperty<g2o::DoubleProperty>("width", 7), nullptr);
    EXPECT_TRUE(map.updatePropertyFromString("width", "5"));
    EXPECT_EQ(made->value(), 5);
  }
  EXPECT_EQ(CountedProperty::deleted, 1);
}

TEST(PropertyMap, OwnsAddedPropertiesUnlessTheirNameIsTaken) {
  CountedProperty::deleted = 0;
  {
    g2o::PropertyMap map;
    EXPECT_TRUE(map.addProperty(new CountedProperty("width", 1)));
    CountedProperty refused("width", 2);
    EXPECT_FALSE(map.addProperty(&refused));
    EXPECT_TRUE(map.eraseProperty("width"));
    EXPECT_EQ(CountedProperty::deleted, 1);
    EXPECT_FALSE(map.eraseProperty("width"));
    EXPECT_TRUE(map.addProperty(new CountedProperty("height", 3)));
  }
  // The map deletes "width" and "height". The refused property is destroyed at the end of its scope.
  EXPECT_EQ(CountedProperty::deleted, 3);
}

TEST(PropertyMap, WritesCommaSeparatedLinesWithoutATrailingComma) {
  g2o::PropertyMap map;
  map.makeProperty<g2o::IntProperty>("a", 1);
  map.makeProperty<g2o::StringProperty>("b", "two");
  std::ostringstream out;
  map.writeToCSV(out);
  EXPECT_EQ(out.str(), "a,b\n1,two\n");
}

}  // namespace
