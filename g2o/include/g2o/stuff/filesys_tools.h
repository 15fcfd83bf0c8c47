// SPDX-License-Identifier: BSD-3-Clause
// Names of files, and files.
#pragma once
#ifndef G2O_FILESYS_TOOLS_H
#define G2O_FILESYS_TOOLS_H

#include <regex>
#include <string>
#include <vector>

#include "g2o/stuff/g2o_stuff_api.h"
#include "g2o/stuff/string_tools.h"

namespace g2o {

/// "/a/b.tar.gz": extension "gz", pure filename "/a/b.tar", base name "b.tar.gz", directory "/a". Empty where
/// there is none.
G2O_STUFF_API std::string getFileExtension(const std::string& filename);
G2O_STUFF_API std::string getPureFilename(const std::string& filename);
G2O_STUFF_API std::string getBasename(const std::string& filename);
G2O_STUFF_API std::string getDirname(const std::string& filename);
/// With another extension, if it has one. newExt may begin with its dot; with `stripDot` it must.
G2O_STUFF_API std::string changeFileExtension(const std::string& filename, const std::string& newExt,
                                              bool stripDot = false);

/// Whether there is such a file (or folder); `regular`: that is no folder.
G2O_STUFF_API bool fileExists(const char* filename, bool regular = false);
inline bool fileExists(const std::string& filename, bool regular = false) {
  return fileExists(filename.c_str(), regular);
}

/// The files whose names fit a pattern of the shell, in order: * ? [ ]. Only of the last folder of the path.
G2O_STUFF_API std::vector<std::string> getFilesByPattern(const char* pattern);
inline std::vector<std::string> getFilesByPattern(const std::string& pattern) {
  return getFilesByPattern(pattern.c_str());
}
/// The paths of the files of a folder that match as a whole, with the folder or without, in order.
G2O_STUFF_API std::vector<std::string> getFilesByPattern(const std::string& directory,
                                                         const std::regex& pattern);

#if __cplusplus >= 201703L
// The functions above for a std::string_view.
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
