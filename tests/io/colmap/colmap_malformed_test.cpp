// SPDX-License-Identifier: BSD-3-Clause
// Malformed COLMAP models, as text and binary.
#include <gmock/gmock.h>

#include <bit>
#include <cmath>

#include "io/colmap/model_folder.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// The complaint about the small model with one text replaced.
std::string complaint_after(std::string ModelTexts::*file, const std::string& old, const std::string& fresh) {
  ModelTexts texts;
  std::string& text = texts.*file;
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  text.replace(at, old.size(), fresh);
  return complaint_of([&] { read_model_texts(texts); });
}

TEST(ColmapText, NamesTheLineAndTheColumnOfAnErrorInTheCameras) {
  const auto complaint = [](const char* old, const char* fresh) {
    return complaint_after(&ModelTexts::cameras, old, fresh);
  };
  EXPECT_THAT(
      complaint("PINHOLE", "HOLE"),
      StartsWith("cameras.txt:4:3: expected a camera model (SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, "));
  EXPECT_EQ(complaint("2 PINHOLE", "7 PINHOLE"),
            "cameras.txt:4:1: expected the id of a new camera, got 7 again");
  EXPECT_EQ(complaint("2 PINHOLE", "-2 PINHOLE"),
            "cameras.txt:4:1: expected the id of a camera (an integer from 0 to 4294967295), got '-2'");
  EXPECT_EQ(
      complaint("240 -0.1", "240"),
      "cameras.txt:3:36: expected a parameter of the camera (a finite number), got the end of the line");
  EXPECT_EQ(complaint("240 -0.1", "240 -0.1 0"), "cameras.txt:3:42: expected the end of the line, got '0'");
  EXPECT_EQ(complaint("710", "nan"),
            "cameras.txt:4:23: expected a parameter of the camera (a finite number), got 'nan'");
}

TEST(ColmapText, NamesTheLineAndTheColumnOfAnErrorInTheImages) {
  const auto complaint = [](const std::string& old, const std::string& fresh) {
    return complaint_after(&ModelTexts::images, old, fresh);
  };
  EXPECT_EQ(complaint("3 7 the", "3 8 the"),
            "images.txt:4:22: expected the id of a camera, got 8, which does not exist");
  EXPECT_EQ(complaint(" the first.jpg", ""),
            "images.txt:4:23: expected the name of the image, got the end of the line");
  EXPECT_EQ(complaint("the first", std::string("t\0e", 3)),
            "images.txt:4:24: expected the name of the image, got 't\\x00e.jpg'");
  EXPECT_EQ(complaint("250 30", "250 31"),
            "images.txt:5:9: expected the id of a point, got 31, which does not exist");
  EXPECT_EQ(
      complaint("201 4", "201"),
      "images.txt:5:40: expected the id of a point, or -1 (an integer from 0 to 18446744073709551615), got "
      "the end of the line");
  EXPECT_EQ(complaint("1.5", "inf"),
            "images.txt:5:12: expected a coordinate of a 2-D point (a finite number), got 'inf'");
  EXPECT_EQ(complaint("6 1 0 0 0", "5 1 0 0 0"),
            "images.txt:8:1: expected the id of a new image, got 5 again");
  EXPECT_EQ(complaint("6 1 0 0 0", "6 0 0 0 0"),
            "images.txt:8:3: image 6: expected a quaternion QW QX QY QZ of length 1 (± 0.001), got one of "
            "length 0");
  EXPECT_THAT(
      complaint("11 0.8 0 0.6 0 1 2 3", "11 1 2 3 0.8 0 0.6 0"),  // the translation first
      HasSubstr("images.txt:4:4: image 11: expected a quaternion QW QX QY QZ of length 1 (± 0.001), got "
                "one of length 3.82"));
  EXPECT_THAT(complaint("0 0.125", "1e200 0.125"), HasSubstr("expected a pose with moderate values"));
}

TEST(ColmapText, NamesTheLineAndTheColumnOfAnErrorInThePoints) {
  const auto complaint = [](const char* old, const char* fresh) {
    return complaint_after(&ModelTexts::points, old, fresh);
  };
  EXPECT_EQ(complaint("17 1 1", "30 1 1"), "points3D.txt:5:1: expected the id of a new point, got 30 again");
  EXPECT_EQ(complaint("17 1 1", "9223372036854775807 1 1"),
            "points3D.txt:5:1: expected the id of a point (at most 2^62), got 9223372036854775807");
  EXPECT_EQ(complaint("255", "256"),
            "points3D.txt:3:14: expected a color of the point (an integer from 0 to 255), got '256'");
  EXPECT_EQ(complaint("0.5 11", "0.5 12"),
            "points3D.txt:3:28: expected the id of an image, got 12, which does not exist");
  EXPECT_EQ(complaint("0.5 11 0", "0.5 11 4"),
            "points3D.txt:3:28: expected a 2-D point of image 11, which has 4, got index 4");
  EXPECT_EQ(complaint("5 1\n", "5\n"),
            "points3D.txt:3:34: expected the index of a 2-D point (an integer from 0 to 4294967295), got the "
            "end of "
            "the line");
}

class ColmapBinary : public testing::Test {
 protected:
  ColmapBinary() { write_graph(folder_.path(), read_model_texts({}), {.format = "COLMAP"}); }

  std::string complaint_with(const std::string& name, const std::string& content) const {
    const std::string before = folder_.content(name);
    folder_.write(name, content);
    std::string complaint = complaint_of([&] { read_graph(folder_.path()); });
    folder_.write(name, before);
    return complaint;
  }
  /// The complaint if the bytes from `at` on are those of `value`.
  std::string complaint_after(const std::string& name, std::size_t at, std::uint64_t value,
                              std::size_t bytes) const {
    std::string content = folder_.content(name);
    for (std::size_t i = 0; i < bytes; ++i) content[at + i] = static_cast<char>(value >> (8 * i));
    return complaint_with(name, content);
  }

  const TestFolder folder_{"binary_model"};
};

TEST_F(ColmapBinary, IsRefusedWhereverItIsTruncated) {
  for (const std::string name : {"cameras.bin", "images.bin", "points3D.bin"}) {
    const std::string content = folder_.content(name);
    for (std::size_t size = 0; size < content.size(); ++size)
      EXPECT_THAT(complaint_with(name, content.substr(0, size)), StartsWith(name + ":1:")) << size;
    EXPECT_EQ(complaint_with(name, content + "xy"), name + ":1:" + std::to_string(content.size() + 1) +
                                                        ": expected the end of the file, got 2 more bytes");
  }
}

TEST_F(ColmapBinary, IsRefusedAtOnceIfACountDoesNotFitIntoTheFile) {
  constexpr std::uint64_t kHuge = 1'000'000'000'000;
  EXPECT_EQ(complaint_after("points3D.bin", 0, kHuge, 8),
            "points3D.bin:1:1: expected at most 3 points, because the file has only 193 more bytes, got "
            "1000000000000");
  EXPECT_THAT(complaint_after("cameras.bin", 0, ~std::uint64_t{0}, 8),
              StartsWith("cameras.bin:1:1: expected at most"));
  EXPECT_THAT(complaint_after("images.bin", 8 + 4 + 56 + 4 + 14, kHuge, 8),
              StartsWith("images.bin:1:87: expected at most 12 2-D points of the image"));
  EXPECT_THAT(complaint_after("points3D.bin", 51, kHuge, 8),
              StartsWith("points3D.bin:1:52: expected at most 17 observations of the point"));
}

TEST_F(ColmapBinary, NamesTheByteOfAnError) {
  EXPECT_THAT(complaint_after("cameras.bin", 12, 17, 4),
              StartsWith("cameras.bin:1:13: expected a camera model from 0 to 16 (SIMPLE_PINHOLE, "));
  EXPECT_EQ(complaint_after("points3D.bin", 16, std::bit_cast<std::uint64_t>(std::nan("")), 8),
            "points3D.bin:1:17: expected a coordinate of the point (a finite number), got nan");
  EXPECT_EQ(complaint_after("images.bin", 68, 99, 4),
            "images.bin:1:69: expected the id of a camera, got 99, which does not exist");
}

}  // namespace
}  // namespace boxplus
