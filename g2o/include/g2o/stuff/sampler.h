// SPDX-License-Identifier: BSD-3-Clause
// Random scalars and vectors.
#pragma once
#ifndef G2O_SAMPLER_H
#define G2O_SAMPLER_H

// clang-format off: this header comes first, because it sets the alignment of Eigen
#include "g2o/config.h"
// clang-format on

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <random>

#include "g2o/stuff/g2o_stuff_api.h"

namespace g2o {

/// Return a random value from a normal or a uniform distribution. If `generator` is nullptr, the functions
/// use the generator of the calling thread.
G2O_STUFF_API double sampleGaussian(std::mt19937* generator = nullptr);
G2O_STUFF_API double sampleUniform(double min = 0., double max = 1., std::mt19937* generator = nullptr);

/// Samples normally distributed vectors with mean zero.
template <class SampleType, class CovarianceType>
class GaussianSampler {
 public:
  GaussianSampler() = default;
  GaussianSampler(const GaussianSampler&) = delete;
  GaussianSampler& operator=(const GaussianSampler&) = delete;

  /// `cov` must be positive definite.
  void setDistribution(const CovarianceType& cov) { _cholesky = cov.llt().matrixL(); }
  SampleType generateSample() {
    SampleType s(_cholesky.rows());
    for (Eigen::Index i = 0; i < s.size(); ++i) s(i) = sampleGaussian(&_generator);
    return SampleType(_cholesky * s);
  }
  void seed(unsigned int s) { _generator.seed(s); }

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

 protected:
  CovarianceType _cholesky;
  std::mt19937 _generator;
};

/// Random numbers from the generator of the calling thread.
class G2O_STUFF_API Sampler {
 public:
  static double gaussRand(double mean, double sigma) { return mean + sampleGaussian() * sigma; }
  static double uniformRand(double lowerBndr, double upperBndr) {
    return sampleUniform(lowerBndr, upperBndr);
  }
  /// Seed the generator from the clock, or with the given value.
  static void seedRand();
  static void seedRand(unsigned int seed);
};

}  // namespace g2o

#endif  // G2O_SAMPLER_H
