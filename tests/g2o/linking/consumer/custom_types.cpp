// SPDX-License-Identifier: BSD-3-Clause
#include <istream>
#include <ostream>

#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/factory.h"

namespace custom {

class Number : public g2o::BaseVertex<1, double> {
 public:
  Number() { _estimate = 0; }
  void setToOriginImpl() override { _estimate = 0; }
  void oplusImpl(const double* update) override { _estimate += update[0]; }
  bool read(std::istream& is) override { return static_cast<bool>(is >> _estimate); }
  bool write(std::ostream& os) const override { return static_cast<bool>(os << _estimate); }
};

class Weighed : public g2o::BaseUnaryEdge<1, double, Number> {
 public:
  void computeError() override { _error[0] = vertexXn<0>()->estimate() - _measurement; }
  bool read(std::istream& is) override { return (is >> _measurement) && readInformationMatrix(is); }
  bool write(std::ostream& os) const override {
    return (os << _measurement << " ") && writeInformationMatrix(os);
  }
};

G2O_REGISTER_TYPE_GROUP(custom)
G2O_REGISTER_TYPE(CUSTOM_NUMBER, Number)
G2O_REGISTER_TYPE_NAME("CUSTOM:WEIGHED", Weighed)

}  // namespace custom
