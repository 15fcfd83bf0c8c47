// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_GRAPH_PARAMETER_CONTAINER_HH_
#define G2O_GRAPH_PARAMETER_CONTAINER_HH_

#include <iosfwd>
#include <map>
#include <string>

#include "g2o/core/parameter.h"

namespace g2o {

/// The parameters of a graph by id.
class G2O_CORE_API ParameterContainer : protected std::map<int, Parameter*> {
 public:
  using BaseClass = std::map<int, Parameter*>;

  /// `isMainStorage`: whether the parameters are deleted with the container.
  explicit ParameterContainer(bool isMainStorage = true);
  ParameterContainer(const ParameterContainer&) = delete;
  ParameterContainer& operator=(const ParameterContainer&) = delete;
  virtual ~ParameterContainer();

  /// False where the id is negative or taken; the parameter then stays the caller's.
  bool addParameter(Parameter* p);
  Parameter* getParameter(int id) const;
  /// Takes the parameter out without deleting it; nullptr where there is none.
  Parameter* detachParameter(int id);
  /// Reads lines of parameters; words that are none are skipped. `renameMap` maps words of the file to those
  /// of the factory.
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
