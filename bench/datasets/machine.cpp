// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/machine.h"

#include <cholmod.h>
#include <fmt/chrono.h>
#include <sys/utsname.h>

#include <Eigen/Core>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

#include "datasets/ceres/ceres_peer.h"
#include "datasets/open_blas.h"
#include "kernels/kernel_table.h"

namespace boxplus::bench {
namespace {

/// Reads a file whose lines have the form "key : value". Returns the value of the first line with this key.
std::string value_of(const char* path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(':');
    if (!line.starts_with(key) || colon == std::string::npos) continue;
    const auto begin = line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "unknown";
}

std::string processor() {
  return fmt::format("{}, {} hardware threads, {} of cache", value_of("/proc/cpuinfo", "model name"),
                     std::thread::hardware_concurrency(), value_of("/proc/cpuinfo", "cache size"));
}

std::string load() {
  double averages[3] = {};
  if (getloadavg(averages, 3) != 3) return "unknown";
  return fmt::format("{:.2f}, {:.2f}, {:.2f} over 1, 5 and 15 minutes at the beginning", averages[0],
                     averages[1], averages[2]);
}

std::string system_name() {
  utsname name{};
  uname(&name);
  return fmt::format("{} {}, {}", name.sysname, name.release, name.machine);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> describe_machine(const std::string& commit) {
  const std::time_t now = std::time(nullptr);
  return {
      {"date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(now))},
      {"boxplus", fmt::format("{}, kernels {}", commit, dense::kernels().name)},
      {"processor", processor()},
      {"memory", value_of("/proc/meminfo", "MemTotal")},
      {"load", load()},
      {"system", system_name()},
      {"compiler",
       fmt::format("GCC {}, -O3; the cost functions of Ceres with -O3 -march=native", __VERSION__)},
      {"BLAS and LAPACK", open_blas_version() + ", one thread"},
      {"CHOLMOD", fmt::format("{}.{}.{}", CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION)},
      {"METIS", std::filesystem::path(library_of("METIS_NodeND")).filename()},
      {"Ceres", std::string(ceres_version())},
      {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
  };
}

}  // namespace boxplus::bench
