// SPDX-License-Identifier: BSD-3-Clause
#include "core/line_stream.h"

#include <locale>

#include "g2o/stuff/logger.h"

namespace g2o {
namespace internal {

LineStream::LineStream(const std::string& line) : std::istringstream(line) {
  imbue(std::locale::classic());
}

LineStream::~LineStream() = default;

void complain(std::istream& is, const std::string& problem) {
  if (auto* line = dynamic_cast<LineStream*>(&is); line != nullptr) {
    line->problem = problem;
  } else {
    G2O_ERROR("{}", problem);
  }
}

}  // namespace internal
}  // namespace g2o
