// SPDX-License-Identifier: BSD-3-Clause
// An independent, dense and slow least-squares solver. Of boxplus, it uses only ⊞ and the robust kernels.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "boxplus/manifold/manifold.h"
#include "boxplus/robust/robust_kernel.h"

namespace boxplus {

class DenseProblem {
 public:
  /// Adds the variable `value`. A fixed variable does not move.
  template <class T>
  void add_variable(std::shared_ptr<T> value, bool fixed) {
    if (fixed) return;
    auto saved = std::make_shared<T>(*value);
    variables_.push_back({detail::tangent_dim(*value),
                          [value, saved](const double* delta) { *value = Manifold<T>::oplus(*saved, delta); },
                          [value, saved] { *saved = *value; }});
  }

  void add_edge(std::function<Eigen::VectorXd()> error, Eigen::MatrixXd information,
                std::shared_ptr<const RobustKernel> kernel) {
    edges_.push_back({std::move(error), std::move(information), std::move(kernel)});
  }

  /// The sum of ρ(eᵀΩe) over all edges.
  double cost() const {
    double sum = 0;
    for (const Edge& edge : edges_) {
      const Eigen::VectorXd e = edge.error();
      const double e2 = e.dot(edge.information * e);
      sum += edge.kernel ? (*edge.kernel)(e2).value : e2;
    }
    return sum;
  }

  /// Levenberg-Marquardt with numeric Jacobians, until no step decreases the cost.
  double minimize() {
    double lambda = 1e-6, best = cost();
    for (int iteration = 0; iteration < 200; ++iteration) {
      keep();
      Eigen::MatrixXd H;
      Eigen::VectorXd g;
      linearize(H, g);
      bool lowered = false;
      for (int tries = 0; tries < 25 && !lowered; ++tries) {
        Eigen::MatrixXd damped = H;
        damped.diagonal() *= 1 + lambda;
        damped.diagonal().array() += 1e-12;
        const Eigen::VectorXd step = damped.ldlt().solve(-g);
        move(step);
        const double now = cost();
        lowered = now < best;
        if (lowered) {
          const double decrease = best - now;
          best = now;
          lambda = std::max(1e-12, lambda / 5);
          if (decrease < 1e-15 * best) return best;
        } else {
          move(Eigen::VectorXd::Zero(step.size()));
          lambda *= 10;
        }
      }
      if (!lowered) return best;
    }
    return best;
  }

 private:
  struct Variable {
    int dim;
    std::function<void(const double*)> set_from_saved;
    std::function<void()> keep;
  };
  struct Edge {
    std::function<Eigen::VectorXd()> error;
    Eigen::MatrixXd information;
    std::shared_ptr<const RobustKernel> kernel;
  };

  void keep() {
    for (Variable& v : variables_) v.keep();
  }
  void move(const Eigen::VectorXd& step) {
    Eigen::Index at = 0;
    for (Variable& v : variables_) {
      v.set_from_saved(step.data() + at);
      at += v.dim;
    }
  }
  Eigen::Index dim() const {
    Eigen::Index sum = 0;
    for (const Variable& v : variables_) sum += v.dim;
    return sum;
  }

  void linearize(Eigen::MatrixXd& H, Eigen::VectorXd& g) {
    constexpr double kStep = 1e-5;
    const Eigen::Index n = dim();
    std::vector<Eigen::VectorXd> error;
    std::vector<Eigen::MatrixXd> jacobian;
    for (const Edge& edge : edges_) {
      error.push_back(edge.error());
      jacobian.emplace_back(error.back().size(), n);
    }
    for (Eigen::Index c = 0; c < n; ++c) {
      const auto at = [&](double h) {
        Eigen::VectorXd delta = Eigen::VectorXd::Zero(n);
        delta[c] = h;
        move(delta);
      };
      for (std::size_t k = 0; k < edges_.size(); ++k) jacobian[k].col(c).setZero();
      for (const auto& [h, weight] : {std::pair(kStep, 8.0), std::pair(-kStep, -8.0),
                                      std::pair(2 * kStep, -1.0), std::pair(-2 * kStep, 1.0)}) {
        at(h);
        for (std::size_t k = 0; k < edges_.size(); ++k)
          jacobian[k].col(c) += weight / (12 * kStep) * edges_[k].error();
      }
    }
    move(Eigen::VectorXd::Zero(n));
    H = Eigen::MatrixXd::Zero(n, n);
    g = Eigen::VectorXd::Zero(n);
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const Edge& edge = edges_[k];
      const double e2 = error[k].dot(edge.information * error[k]);
      const double weight = edge.kernel ? std::max(0.0, (*edge.kernel)(e2).first) : 1;
      H += weight * jacobian[k].transpose() * edge.information * jacobian[k];
      g += weight * jacobian[k].transpose() * edge.information * error[k];
    }
  }

  std::vector<Variable> variables_;
  std::vector<Edge> edges_;
};

}  // namespace boxplus
