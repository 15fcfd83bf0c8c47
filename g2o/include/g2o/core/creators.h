// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_CREATORS_H
#define G2O_CREATORS_H

#include <memory>
#include <string>
#include <typeinfo>

#include "g2o/core/hyper_graph.h"

namespace g2o {

/// Creates elements of one type.
class G2O_CORE_API AbstractHyperGraphElementCreator {
 public:
  AbstractHyperGraphElementCreator();
  virtual ~AbstractHyperGraphElementCreator();
  /// Returns a new element. The caller owns it.
  virtual HyperGraph::HyperGraphElement* construct() = 0;
  /// Returns typeid(T).name() for the type T of the elements.
  virtual const std::string& name() const = 0;
};

template <typename T>
class HyperGraphElementCreator : public AbstractHyperGraphElementCreator {
 public:
  HyperGraphElementCreator() : _name(typeid(T).name()) {}
  HyperGraph::HyperGraphElement* construct() override { return new T; }
  const std::string& name() const override { return _name; }

 protected:
  std::string _name;
};

}  // namespace g2o

#endif  // G2O_CREATORS_H
