// SPDX-License-Identifier: BSD-3-Clause
// A small COLMAP model, and folders for tests.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/text_source.h"

namespace boxplus {

/// The three files of a model as text.
struct ModelTexts {
  std::string cameras =
      "# CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS...\n"
      "# Cameras: 3\n"
      "7 SIMPLE_RADIAL 640 480 500 320 240 -0.1\n"
      "2 PINHOLE 800 600 700 710 400.5 300.25\n"
      "9 OPENCV 100 100 90 91 50 50 0 0 0 0\n";
  /// Image 11 has two features that show a point, one that shows none, and one that shows a point again.
  std::string images =
      "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME\n"
      "# (X Y POINT3D_ID)...\n"
      "# Images: 3\n"
      "11 0.8 0 0.6 0 1 2 3 7 the first.jpg\n"
      "320 250 30 1.5 2.5 -1 300 200 4 301 201 4\n"
      "5 1 0 0 0 0 0.125 -0.25 2 b/second.png\n"
      "400 300 4 410 310 30\n"
      "6 1 0 0 0 0 0 0 7 third.jpg\n"
      "\n";
  std::string points =
      "# POINT3D_ID X Y Z R G B ERROR (IMAGE_ID POINT2D_INDEX)...\n"
      "# Points: 3\n"
      "30 0.1 0.2 5 255 128 0 0.5 11 0 5 1\n"
      "4 -0.1 0.3 6 1 2 3 1.25 5 0 11 2 11 3\n"
      "17 1 1 8 0 0 0 -1\n";
  bool operator==(const ModelTexts&) const = default;
};

/// An empty folder that is removed at the end of the test.
class TestFolder {
 public:
  explicit TestFolder(const std::string& name)
      : path_(testing::TempDir() + "boxplus_" + std::to_string(::getpid()) + "_" + std::to_string(count++) +
              "_" + name) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  ~TestFolder() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::string content(const std::string& name) const {
    std::string memory;
    return std::string(TextSource::of_file(file(name)).text(memory));
  }
  void write(const ModelTexts& model) const {
    write("cameras.txt", model.cameras);
    write("images.txt", model.images);
    write("points3D.txt", model.points);
  }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(file(name), std::ios::binary) << content;
  }
  ModelTexts texts() const {
    return {content("cameras.txt"), content("images.txt"), content("points3D.txt")};
  }

 private:
  static inline int count = 0;
  std::string path_;
};

inline void PrintTo(const ModelTexts& model, std::ostream* out) {
  *out << "\n" << model.cameras << model.images << model.points;
}

inline GraphFile read_model_texts(const ModelTexts& model) {
  const TestFolder folder("model");
  folder.write(model);
  return read_graph(folder.path());
}

inline ModelTexts written_texts(const GraphFile& file) {
  const TestFolder folder("written");
  write_graph(folder.path(), file, {.format = "COLMAP-text"});
  return folder.texts();
}

/// The message of the exception that `f` throws, without the folder.
template <class F>
std::string complaint_of(F&& f) {
  try {
    f();
  } catch (const Error& error) {
    const std::string text = error.what();
    const std::size_t folder = text.find("_model/");
    return folder == std::string::npos ? text : text.substr(folder + 7);
  }
  return "no complaint";
}

}  // namespace boxplus
