// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace boxplus {

/// The name of a file that is removed when this object is destroyed, or by remove_temporary_files() when a
/// signal ends the process. May be empty.
class TemporaryName {
 public:
  TemporaryName() = default;
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  /// Takes ownership of a file that was just created.
  void assign(std::string name);
  /// Gives up ownership, because the file was renamed and stays.
  void release();

  bool empty() const { return name_.empty(); }
  const char* c_str() const { return name_.c_str(); }

 private:
  std::string name_;
  int slot_ = -1;
};

}  // namespace boxplus
