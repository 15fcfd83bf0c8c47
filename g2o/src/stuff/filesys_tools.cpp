// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/filesys_tools.h"

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

namespace g2o {
namespace {

namespace fs = std::filesystem;

/// The position of the dot before the file extension, or npos if the last part of the path has no extension.
size_t dot_of(const std::string& filename) {
  const size_t dot = filename.rfind('.'), slash = filename.rfind('/');
  return dot != std::string::npos && slash != std::string::npos && dot < slash ? std::string::npos : dot;
}

}  // namespace

std::string getFileExtension(const std::string& filename) {
  const size_t dot = dot_of(filename);
  return dot == std::string::npos ? "" : filename.substr(dot + 1);
}

std::string getPureFilename(const std::string& filename) {
  return filename.substr(0, dot_of(filename));
}

std::string getBasename(const std::string& filename) {
  return filename.substr(filename.rfind('/') + 1);
}

std::string getDirname(const std::string& filename) {
  const size_t slash = filename.rfind('/');
  return slash == std::string::npos ? "" : filename.substr(0, slash);
}

std::string changeFileExtension(const std::string& filename, const std::string& newExt, bool stripDot) {
  const size_t dot = dot_of(filename);
  if (dot == std::string::npos) return filename;
  const bool brings_dot = stripDot || (!newExt.empty() && newExt.front() == '.');
  return filename.substr(0, brings_dot ? dot : dot + 1) + newExt;
}

bool fileExists(const char* filename, bool regular) {
  std::error_code error;
  const fs::file_status status = fs::status(filename, error);
  return regular ? fs::is_regular_file(status) : fs::exists(status);
}

std::vector<std::string> getFilesByPattern(const char* pattern) {
  const fs::path path(pattern);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<std::string> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (fnmatch(path.filename().c_str(), name.c_str(), FNM_PERIOD) != 0) continue;
    found.push_back(path.has_parent_path() ? (path.parent_path() / name).string() : name);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::string> getFilesByPattern(const std::string& directory, const std::regex& pattern) {
  std::vector<std::string> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string path = entry.path().string(), name = entry.path().filename().string();
    if (!entry.is_regular_file(error)) continue;
    if (std::regex_match(name, pattern) || std::regex_match(path, pattern)) found.push_back(path);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace g2o
