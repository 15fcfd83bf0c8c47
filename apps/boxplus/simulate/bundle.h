// SPDX-License-Identifier: BSD-3-Clause
// boxplus simulate ba -o FILE: simulates a problem of bundle adjustment.
#pragma once

#include <string>
#include <vector>

#include "boxplus/testing/simulate_bundle.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace boxplus::app {

struct BundleArguments {
  BundleShape shape = BundleShape::kStreet;
  BundleOptions options;
};

/// Adds the options that only the world `ba` has, and returns them.
std::vector<CLI::Option*> add_bundle_options(CLI::App& command, BundleArguments& arguments);

/// Simulates the problem and writes it. An empty `truth` means no file.
int simulate_bundle_file(const BundleArguments& arguments, const std::string& output,
                         const std::string& truth);

}  // namespace boxplus::app
