// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "boxplus/graph/handle.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {

/// The tags in a file for which no type is registered. The report on the file contains a note for each of
/// these tags. A line with an unknown tag may also be the reason why a vertex is missing.
class UnknownTags {
 public:
  /// Records a line that begins with an unknown tag.
  void add(std::string_view line, std::int64_t number);
  /// The reason why there is no vertex (or parameter) with this id, if a line with an unknown tag has the id.
  /// Otherwise, an empty string.
  std::string reason_for_missing(Id id, bool is_parameter) const;
  /// Appends one note for each tag.
  void append_notes(std::vector<GraphFile::Note>& notes) const;

 private:
  struct Occurrences {
    std::int64_t count = 0, first_line = 0;
  };
  /// A line with an id after its tag. Such a line may define a vertex or a parameter.
  struct IdLine {
    const std::string* tag;
    std::int64_t number;
  };

  std::map<std::string, Occurrences> tags_;         // the key is the tag in quotation marks
  std::unordered_map<Id, IdLine> lines_of_ids_[2];  // [0] for vertices, [1] for parameters
};

}  // namespace boxplus
