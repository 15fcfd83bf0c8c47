// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/datasets.h"

#include <array>
#include <filesystem>

#include "plan/plan.h"

namespace boxplus::bench {
namespace {

constexpr std::array kDatasets{
    Dataset{"posegraph2d/intel_1728.g2o", 45.0046958, true},
    Dataset{"posegraph2d/M3500.g2o", 137.912951, true},
    Dataset{"posegraph2d/city10000.g2o", 511.985164, true},
    Dataset{"posegraph2d/csail.g2o", 38.9562859, false},
    Dataset{"posegraph2d/MITb.g2o", 41.1632688, false},
    Dataset{"posegraph2d/w10000.graph", 171545.447, true},
    Dataset{"posegraph3d/smallGrid3D.g2o", 458.153785, false},
    Dataset{"posegraph3d/sphere2500.g2o", 727.149412, true},
    Dataset{"posegraph3d/parking-garage.g2o", 1.23868351, true},
    Dataset{"posegraph3d/torus3D.g2o", 14574.7464, true},
    Dataset{"posegraph3d/sphere_bignoise_vertex3.g2o", 743862.712, true},
    Dataset{"landmark2d/victoriaPark-full.g2o", 389.787423, false},
    Dataset{"landmark2d/world-2000-full.g2o", 7657.552126, false},
};

}  // namespace

std::string Dataset::name() const {
  return std::filesystem::path(path).stem().string();
}

std::span<const Dataset> datasets() {
  return kDatasets;
}

GraphFile read_anchored(const std::string& path) {
  ReadOptions options;
  options.threads = 1;
  GraphFile file = read_graph(path, options);
  for (const detail::GaugeVertex& held : make_plan(file.graph, {}).held) file.graph.fix(held.vertex);
  return file;
}

}  // namespace boxplus::bench
