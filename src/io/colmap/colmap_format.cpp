// SPDX-License-Identifier: BSD-3-Clause
#include "io/colmap/colmap_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <system_error>

#include "boxplus/base/error.h"
#include "boxplus/io/write_file.h"
#include "io/colmap/frame_reader.h"
#include "io/colmap/model_output.h"
#include "io/colmap/model_reader.h"
#include "io/file_set.h"
#include "io/model/graph_model.h"
#include "io/model/model_graph.h"

namespace boxplus {
namespace {

constexpr std::array<const char*, 3> kNames{"cameras", "images", "points3D"};
/// Files of COLMAP 3.12 and later, which describe images that were taken together.
constexpr std::array<const char*, 2> kFrameNames{"rigs", "frames"};
/// By ModelFile.
constexpr std::array<const char*, 5> kAllNames{kNames[0], kNames[1], kNames[2], kFrameNames[0],
                                               kFrameNames[1]};

/// The names of the files of a model.
std::span<const char* const> names_of(const SparseModel& model) {
  return std::span(kAllNames).first(model.has_frames ? kAllNames.size() : kNames.size());
}

std::string path_of(const std::string& folder, std::string_view name, bool is_text) {
  return (std::filesystem::path(folder) / name).string() + (is_text ? ".txt" : ".bin");
}

template <class Names>
std::vector<std::string> existing_files(const std::string& folder, const Names& names, bool is_text) {
  std::vector<std::string> files;
  std::error_code none;
  for (const char* name : names) {
    std::string path = path_of(folder, name, is_text);
    if (std::filesystem::exists(path, none)) files.push_back(std::move(path));
  }
  return files;
}

bool is_binary(const std::string& folder) {
  return !existing_files(folder, kNames, false).empty();
}

std::unique_ptr<ModelInput> open(const std::string& folder, ModelFile file, bool is_text) {
  TextSource source =
      TextSource::of_file(path_of(folder, kAllNames[static_cast<std::size_t>(file)], is_text));
  return is_text ? text_input(std::move(source)) : binary_input(std::move(source), file);
}

SparseModel read_files(const std::string& folder, bool is_text) {
  std::unique_ptr<ModelInput> cameras, images, points, rigs, frames;
  open_together(folder, [&] {
    cameras = open(folder, ModelFile::kCameras, is_text);
    images = open(folder, ModelFile::kImages, is_text);
    points = open(folder, ModelFile::kPoints, is_text);
    if (existing_files(folder, kFrameNames, is_text).empty()) return;
    rigs = open(folder, ModelFile::kRigs, is_text);
    frames = open(folder, ModelFile::kFrames, is_text);
  });
  SparseModel model = read_model(*cameras, *images, *points);
  if (frames) read_frames(*rigs, *frames, model);
  return model;
}

GraphFile read(const std::string& folder, bool is_text) {
  GraphFile file = graph_of(read_files(folder, is_text));
  for (std::string& text : unusual_parts(*file.model)) file.notes.push_back({0, std::move(text)});
  return file;
}

/// Refuses a folder with files that COLMAP would read instead of the written ones, or together with them.
void check_folder(const SparseModel& model, const std::string& folder, bool is_text) {
  std::vector<std::string> others;
  if (is_text) others = existing_files(folder, kAllNames, false);
  if (!model.has_frames) {
    for (std::string& file : existing_files(folder, kFrameNames, is_text)) others.push_back(std::move(file));
  }
  if (others.empty()) return;
  throw FileError(
      fmt::format("{}: expected a folder without {}, which COLMAP would read instead of the new files; "
                  "choose another folder",
                  folder, std::filesystem::path(others.front()).filename().string()));
}

/// The first folder of the path that exists.
std::string existing_folder(const std::string& folder) {
  std::error_code none;
  std::filesystem::path path = std::filesystem::absolute(folder, none);
  while (!std::filesystem::exists(path, none) && path.has_parent_path() && path != path.parent_path())
    path = path.parent_path();
  return path.string();
}

void check(const SparseModel& model, const std::string& folder, bool is_text) {
  require_names(model, is_text);
  check_folder(model, folder, is_text);
  std::error_code none;
  if (!std::filesystem::exists(folder, none))
    return require_writable(path_of(existing_folder(folder), kNames.front(), is_text));
  for (const char* name : names_of(model)) {
    const std::string path = path_of(folder, name, is_text);
    require_regular(path);
    require_writable(path);
  }
}

void write(const GraphFileView& file, const std::string& folder, bool is_text) {
  const SparseModel model = model_of(file);
  check(model, folder, is_text);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(fmt::format("{}: cannot be created: {}", folder, error.message()));
  constexpr std::array kWriters{write_cameras, write_images, write_points, write_rigs, write_frames};
  const std::span<const char* const> names = names_of(model);
  std::vector<NewFile> files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    files.push_back({path_of(folder, names[i], is_text), [&, i](TextSink sink) {
                       kWriters[i](model, is_text ? *text_output(sink) : *binary_output(sink));
                     }});
  }
  replace_together(folder, files);
}

FileFormat format(const char* name, bool is_text) {
  const auto is_model = [is_text](const std::string& folder) {
    const bool has_binary = is_binary(folder);
    return is_text ? !has_binary && !existing_files(folder, kNames, true).empty() : has_binary;
  };
  return {
      .name = name,
      .folder = {.recognize = is_model,
                 .read = [is_text](const std::string& folder,
                                   const ReadOptions& /*options*/) { return read(folder, is_text); },
                 .check = [is_text](const GraphFileView& file,
                                    const std::string& folder) { check(model_of(file), folder, is_text); },
                 .write = [is_text](const GraphFileView& file,
                                    const std::string& folder) { write(file, folder, is_text); }},
      .losses = model_losses};
}

}  // namespace

SparseModel read_colmap(const std::string& folder) {
  return read_files(folder, !is_binary(folder));
}

FileFormat colmap_format() {
  return format("COLMAP", false);
}

FileFormat colmap_text_format() {
  return format("COLMAP-text", true);
}

}  // namespace boxplus
