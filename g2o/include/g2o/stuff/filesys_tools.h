// SPDX-License-Identifier: BSD-3-Clause
// Names of files, and files.
#pragma once

#include <string>
#include <vector>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {

/// "/a/b.tar.gz": extension "gz", pure filename "/a/b.tar", base name "b.tar.gz", directory "/a". Empty where
/// there is none.
G2O_STUFF_API std::string getFileExtension(const std::string& filename);
G2O_STUFF_API std::string getPureFilename(const std::string& filename);
G2O_STUFF_API std::string getBasename(const std::string& filename);
G2O_STUFF_API std::string getDirname(const std::string& filename);
/// With another extension, where it has one; `stripDot`: newExt begins with its dot.
G2O_STUFF_API std::string changeFileExtension(const std::string& filename, const std::string& newExt,
                                              bool stripDot = false);

/// Whether there is such a file (or folder); `regular`: that is no folder.
G2O_STUFF_API bool fileExists(const char* filename, bool regular = false);

/// The files whose names fit a pattern of the shell, in order: * ? [ ]. Only of the last folder of the path.
G2O_STUFF_API std::vector<std::string> getFilesByPattern(const char* pattern);

}  // namespace g2o
