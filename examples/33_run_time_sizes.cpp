// SPDX-License-Identifier: BSD-3-Clause
// A vertex whose size is chosen at run time, and changes. Two thermometers follow the temperature of a day.
// A polynomial describes it, but nobody knows of which degree: the degree grows until chi2 shows that only
// noise is left. One thermometer has an offset, which is a vertex of its own.
#include <boxplus/boxplus.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>

using namespace boxplus;

constexpr double kSigma = 0.2;  // noise of a thermometer, in degrees Celsius
constexpr double kTrueOffset = 1.5;
constexpr int kLargestDegree = 12;

/// The coefficients of a polynomial in the Chebyshev polynomials T₀, T₁, …; as many as the degree demands.
using Coefficients = Vector<double, kDynamic>;

/// Σ c_i T_i(x) for x in [−1, 1], by T_{i+1} = 2 x T_i − T_{i−1}.
template <class C>
auto value_at(const C& coefficients, double x) {
  typename C::Scalar sum = coefficients[0];
  double last = 1, current = x;  // T₀, T₁
  for (Eigen::Index i = 1; i < coefficients.size(); ++i) {
    sum += coefficients[i] * current;
    last = std::exchange(current, 2 * x * current - last);
  }
  return sum;
}

/// A measurement at the time x. It has one row for a polynomial of any degree. The thermometer has an offset
/// if a second vertex says so.
struct Temperature {
  double x, celsius;

  template <class C>
  auto error(const C& coefficients) const {
    return typename C::Scalar(value_at(coefficients, x) - celsius);
  }
  template <class C, class Offset>
  auto error(const C& coefficients, const Offset& offset) const {
    return typename C::Scalar(value_at(coefficients, x) + offset[0] - celsius);
  }
};

int main() {
  Coefficients truth(7);  // degree 6
  truth << 12, 2, -5, -1.5, 1, 0.5, -0.8;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, kSigma);

  Graph graph;
  const auto curve = graph.add_vertex(Coefficients(Coefficients::Zero(1)));  // degree 0
  const auto offset = graph.add_vertex(Vector<double, 1>(Vector<double, 1>::Zero()));
  for (int k = 0; k <= 144; ++k) {  // every ten minutes
    const double x = k / 72.0 - 1, celsius = value_at(truth, x);
    graph.add_edge(Temperature{x, celsius + noise(random)}, 1 / (kSigma * kSigma), curve);
    if (k % 3 == 0)
      graph.add_edge(Temperature{x, celsius + kTrueOffset + noise(random)}, 1 / (kSigma * kSigma), curve,
                     offset);
  }

  // chi2 per degree of freedom is 1 if only noise is left. It exceeds this limit by chance in 1 of 700 cases.
  Report report = optimize(graph);
  const auto limit = [&] { return 1 + 3 * std::sqrt(2.0 / static_cast<double>(report.degrees_of_freedom)); };
  std::printf("chi2 per degree of freedom, as the degree grows: ");
  while (report.chi2_per_degree() > limit() && graph.tangent_dim(curve) <= kLargestDegree) {
    std::printf("%.1f, ", report.chi2_per_degree());
    const Coefficients old = graph.estimate(curve);
    Coefficients longer = Coefficients::Zero(old.size() + 1);
    longer.head(old.size()) = old;
    graph.set_estimate(curve, longer);  // all edges stay; the next run has one unknown more
    report = optimize(graph);
  }
  std::printf("and %.2f: a polynomial of degree %d fits\n", report.chi2_per_degree(),
              graph.tangent_dim(curve) - 1);

  const Coefficients& found = graph.estimate(curve);
  double worst = 0;
  for (int k = 0; k <= 144; ++k) {
    const double x = k / 72.0 - 1;
    worst = std::max(worst, std::abs(value_at(found, x) - value_at(truth, x)));
  }
  std::printf("the curve is within %.2f degrees Celsius of the truth\n", worst);
  std::printf("offset of the second thermometer: %.2f degrees Celsius (truth: %.2f)\n",
              graph.estimate(offset)[0], kTrueOffset);
  return report.converged() && found.size() == truth.size() && worst < 0.3 &&
                 std::abs(graph.estimate(offset)[0] - kTrueOffset) < 0.15
             ? 0
             : 1;
}
