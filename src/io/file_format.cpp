// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/file_format.h"

#include <algorithm>

#include "boxplus/base/error.h"
#include "io/gzip.h"

namespace boxplus {

std::string FileFormat::label() const {
  if (is_folder()) return name + " folder";
  return extension == "." + name ? extension : name + "'s " + extension;
}

void FileFormats::add(FileFormat format) {
  const bool is_complete =
      format.is_folder() ? format.can_read() && format.extension.empty()
                         : !format.extension.empty() && format.recognize && (format.read || format.write);
  if (format.name.empty() || !is_complete)
    throw InvalidArgument("file format '" + format.name +
                          "': expected a name, an extension, recognize, and read or write; or a name, and "
                          "recognize and read for a folder");
  for (const FileFormat& other : formats_) {
    const bool has_extension = !format.is_folder() && other.extension == format.extension;
    if (other.name == format.name || has_extension) {
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
  if (is_gzip_name(path)) path = path.substr(0, path.rfind('.'));
  const auto found = std::find_if(formats_.begin(), formats_.end(), [&](const FileFormat& format) {
    return !format.is_folder() && path.ends_with(format.extension);
  });
  return found == formats_.end() ? nullptr : &*found;
}

const FileFormat* FileFormats::recognize(std::string_view beginning) const {
  const auto found = std::find_if(formats_.rbegin(), formats_.rend(), [&](const FileFormat& format) {
    return !format.is_folder() && format.recognize(beginning);
  });
  return found == formats_.rend() ? nullptr : &*found;
}

const FileFormat* FileFormats::recognize_folder(const std::string& folder) const {
  const auto found = std::find_if(formats_.rbegin(), formats_.rend(), [&](const FileFormat& format) {
    return format.is_folder() && format.folder.recognize(folder);
  });
  return found == formats_.rend() ? nullptr : &*found;
}

}  // namespace boxplus
