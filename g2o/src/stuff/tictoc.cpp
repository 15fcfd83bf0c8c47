// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/tictoc.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <sstream>

#include "g2o/stuff/timeutil.h"

namespace g2o {
namespace {

struct Part {
  double started = 0;
  bool runs = false;
  int count = 0;
  double total = 0, shortest = std::numeric_limits<double>::max(), longest = 0;
};

struct Parts {
  std::mutex mutex;
  std::map<std::string, Part> by_name;
};

Parts& parts() {
  static Parts instance;
  return instance;
}

}  // namespace

double tictoc(const char* algorithmPart) {
  static const bool enabled = std::getenv("G2O_ENABLE_TICTOC") != nullptr;
  if (!enabled) return -1;
  const double now = get_monotonic_time();
  const std::lock_guard<std::mutex> lock(parts().mutex);
  Part& part = parts().by_name[algorithmPart];
  part.runs = !part.runs;
  if (part.runs) {
    part.started = now;
    return -1;
  }
  const double seconds = now - part.started;
  ++part.count;
  part.total += seconds;
  part.shortest = std::min(part.shortest, seconds);
  part.longest = std::max(part.longest, seconds);
  return seconds;
}

std::string tictocReport() {
  const std::lock_guard<std::mutex> lock(parts().mutex);
  std::ostringstream out;
  for (const auto& [name, part] : parts().by_name) {
    if (part.count == 0) continue;
    out << name << "\tnumber= " << part.count << "\ttotal= " << part.total << "\tmin= " << part.shortest
        << "\tmean= " << part.total / part.count << "\tmax= " << part.longest << '\n';
  }
  return out.str();
}

}  // namespace g2o
