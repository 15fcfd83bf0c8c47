// SPDX-License-Identifier: BSD-3-Clause
// A fuzz target that checks properties of the reader and writer of COLMAP models, for arbitrary files. An
// input is the files cameras, images and points3D, and then rigs and frames if they are not empty, with the
// line "====" between them. Files that begin with # are text.
//
//   - The reader either returns a graph or throws an InputError.
//   - If a model is written as binary and read again, and written as text, the text is the same as that of
//   the first
//     graph.
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

constexpr std::array<const char*, 5> kNames{"cameras", "images", "points3D", "rigs", "frames"};
constexpr std::size_t kNeeded = 3;  // the other files can be missing

using Files = std::array<std::string, 5>;

Files split(std::string_view input) {
  constexpr std::string_view kSeparator = "====\n";
  Files files;
  for (std::string& file : files) {
    const std::size_t end = std::min(input.find(kSeparator), input.size());
    file = input.substr(0, end);
    input.remove_prefix(std::min(end + kSeparator.size(), input.size()));
  }
  return files;
}

/// The folder of all files, which is removed at the end.
class Root {
 public:
  Root() : path_(parent() / ("boxplus_fuzz_" + std::to_string(::getpid()))) {}
  ~Root() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }
  Root(const Root&) = delete;
  Root& operator=(const Root&) = delete;

  std::string folder(const char* name) const {
    std::filesystem::create_directories(path_ / name);
    return (path_ / name).string();
  }

 private:
  static std::filesystem::path parent() {
    const std::filesystem::path memory("/dev/shm");
    std::error_code none;
    return std::filesystem::is_directory(memory, none) ? memory : std::filesystem::temp_directory_path();
  }
  std::filesystem::path path_;
};

/// A folder that is used for all inputs.
std::string folder(const char* name) {
  static const Root root;
  return root.folder(name);
}

std::string path_of(const std::string& folder, std::size_t file, bool is_text) {
  return folder + "/" + kNames[file] + (is_text ? ".txt" : ".bin");
}

/// The same folder without files.
std::string empty_folder(const char* name) {
  std::string place = folder(name);
  for (const auto& file : std::filesystem::directory_iterator(place)) std::filesystem::remove(file);
  return place;
}

Files written_texts(const GraphFile& file) {
  const std::string place = empty_folder("written_text");
  write_graph(place, file, {.format = "COLMAP-text"});
  Files files;
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::ifstream in(path_of(place, i, true), std::ios::binary);
    files[i].assign(std::istreambuf_iterator<char>(in), {});
  }
  return files;
}

std::optional<GraphFile> read(const Files& files) {
  const bool is_text = files[0].starts_with('#');
  const std::string place = empty_folder(is_text ? "text" : "binary");
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i < kNeeded || !files[i].empty())
      std::ofstream(path_of(place, i, is_text), std::ios::binary) << files[i];
  }
  try {
    return read_graph(place);
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const FileError&) {  // a packed file that is damaged
    return std::nullopt;
  }
}

void check(std::string_view input) {
  const std::optional<GraphFile> file = read(split(input));
  if (!file) return;
  Files texts;
  try {
    texts = written_texts(*file);
  } catch (const InvalidArgument&) {
    return;  // a text cannot have some names of images
  }
  const std::string place = empty_folder("written_binary");
  write_graph(place, *file, {.format = "COLMAP"});
  const Files again = written_texts(read_graph(place));
  if (texts == again) return;
  std::fprintf(stderr, "broken law: a written model does not change when it is read again\n");
  for (std::size_t i = 0; i < texts.size(); ++i)
    std::fprintf(stderr, "── %s, expected ──\n%s── got ──\n%s", kNames[i], texts[i].c_str(),
                 again[i].c_str());
  std::abort();
}

}  // namespace
}  // namespace boxplus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  boxplus::check({reinterpret_cast<const char*>(data), size});
  return 0;
}
