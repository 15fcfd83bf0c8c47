// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_GRAPH_PARAMETER_HH_
#define G2O_GRAPH_PARAMETER_HH_

#include <iosfwd>

#include "g2o/core/hyper_graph.h"

namespace g2o {

/// A constant that edges share, for example a sensor offset or a camera.
class G2O_CORE_API Parameter : public HyperGraph::HyperGraphElement {
 public:
  Parameter();
  ~Parameter() override;
  virtual bool read(std::istream& is) = 0;
  virtual bool write(std::ostream& os) const = 0;
  int id() const { return _id; }
  void setId(int id) { _id = id; }
  HyperGraph::HyperGraphElementType elementType() const override { return HyperGraph::HGET_PARAMETER; }

 protected:
  int _id = -1;
};

using ParameterVector = std::vector<Parameter*>;

/// A parameter that holds one value.
template <typename T>
class BaseParameter : public Parameter {
 public:
  using ParameterType = T;
  const ParameterType& param() const { return parameter_; }
  virtual void setParam(const ParameterType& parameter) { parameter_ = parameter; }

 protected:
  ParameterType parameter_;
};

}  // namespace g2o

#endif  // G2O_GRAPH_PARAMETER_HH_
