// SPDX-License-Identifier: BSD-3-Clause
// Functions for file names and files.
#pragma once
#ifndef G2O_FILESYS_TOOLS_H
#define G2O_FILESYS_TOOLS_H

#include <regex>
#include <string>
#include <vector>

#include "g2o/stuff/g2o_stuff_api.h"
#include "g2o/stuff/string_tools.h"

namespace g2o {

/// Return the parts of a file name. "/a/b.tar.gz" has the extension "gz", the pure filename "/a/b.tar", the
/// base name "b.tar.gz" and the directory "/a". A missing part is empty.
G2O_STUFF_API std::string getFileExtension(const std::string& filename);
G2O_STUFF_API std::string getPureFilename(const std::string& filename);
G2O_STUFF_API std::string getBasename(const std::string& filename);
G2O_STUFF_API std::string getDirname(const std::string& filename);
/// Replaces the extension of a file name, if it has an extension. If `stripDot` is true, newExt must begin
/// with a dot. Otherwise, the dot is optional.
G2O_STUFF_API std::string changeFileExtension(const std::string& filename, const std::string& newExt,
                                              bool stripDot = false);

/// Returns whether a file or folder with this name exists. If `regular` is true, only regular files count.
G2O_STUFF_API bool fileExists(const char* filename, bool regular = false);
inline bool fileExists(const std::string& filename, bool regular = false) {
  return fileExists(filename.c_str(), regular);
}

/// Returns the sorted names of all files that match a shell pattern with * ? [ ]. Only the last part of the
/// path may be a pattern.
G2O_STUFF_API std::vector<std::string> getFilesByPattern(const char* pattern);
inline std::vector<std::string> getFilesByPattern(const std::string& pattern) {
  return getFilesByPattern(pattern.c_str());
}
/// Returns the sorted paths of all files in a folder that match the pattern. The pattern must match the whole
/// file name, or the whole path including the folder.
G2O_STUFF_API std::vector<std::string> getFilesByPattern(const std::string& directory,
                                                         const std::regex& pattern);

#if __cplusplus >= 201703L
// Overloads for std::string_view.
template <typename View, internal::IfView<View> = 0>
std::string getFileExtension(View filename) {
  return getFileExtension(std::string(filename));
}
template <typename View, internal::IfView<View> = 0>
std::string getPureFilename(View filename) {
  return getPureFilename(std::string(filename));
}
template <typename View, internal::IfView<View> = 0>
std::string getBasename(View filename) {
  return getBasename(std::string(filename));
}
template <typename View, internal::IfView<View> = 0>
std::string getDirname(View filename) {
  return getDirname(std::string(filename));
}
template <typename View, typename Text, internal::IfView<View> = 0>
std::string changeFileExtension(View filename, const Text& newExt, bool stripDot = false) {
  return changeFileExtension(std::string(filename), std::string(newExt), stripDot);
}
template <typename View, internal::IfView<View> = 0>
bool fileExists(View filename, bool regular = false) {
  return fileExists(std::string(filename), regular);
}
template <typename View, internal::IfView<View> = 0>
std::vector<std::string> getFilesByPattern(View directory, const std::regex& pattern) {
  return getFilesByPattern(std::string(directory), pattern);
}
#endif

}  // namespace g2o

#endif  // G2O_FILESYS_TOOLS_H
