// SPDX-License-Identifier: BSD-3-Clause
// The unscented transform: Julier, "The scaled unscented transformation", 2002.
#pragma once
#ifndef G2O_UNSCENTED_H
#define G2O_UNSCENTED_H

// clang-format off: this header comes first, because it sets the alignment of Eigen
#include "g2o/config.h"
// clang-format on

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <iostream>
#include <vector>

namespace g2o {

/// A sample with two weights: `_wi` is its weight in the mean, and `_wp` is its weight in the covariance.
template <class SampleType>
struct SigmaPoint {
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  SigmaPoint() : _wi(0), _wp(0) {}
  SigmaPoint(const SampleType& sample, double wi, double wp) : _sample(sample), _wi(wi), _wp(wp) {}
  SampleType _sample;
  double _wi;
  double _wp;
};

/// Computes the sigma points: the mean, and two points along each column of the Cholesky factor. Returns
/// false if the covariance is not positive definite.
template <class SampleType, class CovarianceType>
bool sampleUnscented(std::vector<SigmaPoint<SampleType>>& sigmaPoints, const SampleType& mean,
                     const CovarianceType& covariance) {
  constexpr double kAlpha = 1e-3, kBeta = 2;
  const auto dim = static_cast<double>(mean.size());
  const double lambda = kAlpha * kAlpha * dim;
  const Eigen::LLT<Eigen::MatrixXd> cholesky(covariance);
  if (cholesky.info() != Eigen::Success) return false;
  const Eigen::MatrixXd L = cholesky.matrixL();
  sigmaPoints.clear();
  const double center = (lambda - dim) / lambda, other = 1 / (2 * lambda);
  sigmaPoints.emplace_back(mean, center, center + 1 - kAlpha * kAlpha + kBeta);
  for (Eigen::Index i = 0; i < mean.size(); ++i) {
    const Eigen::VectorXd step = L.col(i) * std::sqrt(lambda);
    sigmaPoints.emplace_back(SampleType(mean + step), other, other);
    sigmaPoints.emplace_back(SampleType(mean - step), other, other);
  }
  return true;
}

/// Computes the mean and the covariance of weighted sigma points.
template <class SampleType, class CovarianceType>
void reconstructGaussian(SampleType& mean, CovarianceType& covariance,
                         const std::vector<SigmaPoint<SampleType>>& sigmaPoints) {
  mean.setZero();
  for (const auto& point : sigmaPoints) mean += point._wi * point._sample;
  covariance.setZero();
  for (const auto& point : sigmaPoints) {
    const SampleType delta = point._sample - mean;
    covariance += point._wp * (delta * delta.transpose());
  }
}

}  // namespace g2o

#endif  // G2O_UNSCENTED_H
