// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/sampler.h"

#include <chrono>

namespace g2o {
namespace {

std::mt19937& shared_generator() {
  thread_local std::mt19937 generator;
  return generator;
}

}  // namespace

// Uses a new distribution for each value, because a distribution may compute two values at once and store one
// of them. After a new seed, the next call would return the stored value, which belongs to the old seed.
double sampleGaussian(std::mt19937* generator) {
  std::normal_distribution<double> gaussian;
  return gaussian(generator != nullptr ? *generator : shared_generator());
}

double sampleUniform(double min, double max, std::mt19937* generator) {
  std::uniform_real_distribution<double> uniform(min, max);
  return uniform(generator != nullptr ? *generator : shared_generator());
}

void Sampler::seedRand() {
  seedRand(static_cast<unsigned int>(std::chrono::system_clock::now().time_since_epoch().count()));
}

void Sampler::seedRand(unsigned int seed) {
  shared_generator().seed(seed);
}

}  // namespace g2o
