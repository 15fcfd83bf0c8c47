// SPDX-License-Identifier: BSD-3-Clause
// The tags in a file that the Factory does not know.
#pragma once

#include <map>
#include <string>

namespace g2o {
namespace internal {

/// Counts the skipped lines of each unknown tag.
class UnknownTags {
 public:
  void add(const std::string& tag, int line);
  /// Logs an error for each tag, in the order of their first lines. It has the number of lines and, if the
  /// tag belongs to a library of the g2o API, how a program gets its type. Of the other tags, only the first
  /// five are named, because a file in another format has very many of them.
  void report() const;

 private:
  struct Lines {
    int first = 0, count = 0;
  };
  std::map<std::string, Lines> tags_;
};

}  // namespace internal
}  // namespace g2o
