// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/file_format.h"

#include <algorithm>

#include "boxplus/base/error.h"

namespace boxplus {

std::string FileFormat::label() const {
  return extension == "." + name ? extension : name + "'s " + extension;
}

void FileFormats::add(FileFormat format) {
  if (format.name.empty() || format.extension.empty() || !format.recognize || !format.read)
    throw InvalidArgument("file format '" + format.name +
                          "': expected a name, an extension, recognize and read");
  for (const FileFormat& other : formats_) {
    if (other.name == format.name || other.extension == format.extension) {
      throw InvalidArgument("file format '" + format.name +
                            "': expected a new name and a new extension, but " + other.label() +
                            " is already registered");
    }
  }
  formats_.push_back(std::move(format));
}

const FileFormat* FileFormats::find(std::string_view name) const {
  const auto found = std::find_if(formats_.begin(), formats_.end(),
                                  [&](const FileFormat& format) { return format.name == name; });
  return found == formats_.end() ? nullptr : &*found;
}

const FileFormat* FileFormats::of_path(std::string_view path) const {
  const auto found = std::find_if(formats_.begin(), formats_.end(),
                                  [&](const FileFormat& format) { return path.ends_with(format.extension); });
  return found == formats_.end() ? nullptr : &*found;
}

const FileFormat* FileFormats::recognize(std::string_view beginning) const {
  const auto found = std::find_if(formats_.rbegin(), formats_.rend(),
                                  [&](const FileFormat& format) { return format.recognize(beginning); });
  return found == formats_.rend() ? nullptr : &*found;
}

}  // namespace boxplus
