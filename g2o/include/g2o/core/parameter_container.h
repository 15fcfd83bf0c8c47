// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_GRAPH_PARAMETER_CONTAINER_HH_
#define G2O_GRAPH_PARAMETER_CONTAINER_HH_

#include <iosfwd>
#include <map>
#include <string>

#include "g2o/core/parameter.h"

namespace g2o {

/// The parameters of a graph, sorted by id.
class G2O_CORE_API ParameterContainer : protected std::map<int, Parameter*> {
 public:
  using BaseClass = std::map<int, Parameter*>;

  /// If `isMainStorage` is true, the container deletes its parameters.
  explicit ParameterContainer(bool isMainStorage = true);
  ParameterContainer(const ParameterContainer&) = delete;
  ParameterContainer& operator=(const ParameterContainer&) = delete;
  virtual ~ParameterContainer();

  /// Returns false if the id is negative or taken. The caller then still owns the parameter.
  bool addParameter(Parameter* p);
  Parameter* getParameter(int id) const;
  /// Removes a parameter without deleting it, and returns the parameter. Returns nullptr if no parameter has
  /// this id.
  Parameter* detachParameter(int id);
  /// Reads the lines that describe parameters and skips all other lines. `renameMap` maps tags of the file to
  /// tags of the factory.
  virtual bool read(std::istream& is, const std::map<std::string, std::string>* renameMap = nullptr);
  virtual bool write(std::ostream& os) const;
  bool isMainStorage() const { return _isMainStorage; }
  void clear();

  using BaseClass::begin;
  using BaseClass::const_iterator;
  using BaseClass::empty;
  using BaseClass::end;
  using BaseClass::iterator;
  using BaseClass::size;

 protected:
  bool _isMainStorage;
};

}  // namespace g2o

#endif  // G2O_GRAPH_PARAMETER_CONTAINER_HH_
