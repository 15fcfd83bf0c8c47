// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimization_algorithm_factory.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

#include "g2o/stuff/logger.h"

namespace g2o {
namespace {

// The factory is not destroyed at exit, because static objects in plug-ins may still unregister themselves at
// that time.
OptimizationAlgorithmFactory*& factory_slot() {
  static OptimizationAlgorithmFactory* slot = nullptr;
  return slot;
}

/// Returns the algorithm of the library solver_eigen that does the same: "lm_var" for "lm_var_cholmod" and
/// "lm_var_csparse". Returns an empty string for all other names.
std::string without_library(const std::string& tag) {
  for (const char* library : {"_cholmod", "_csparse"}) {
    const std::string suffix = library;
    if (tag.size() > suffix.size() && tag.compare(tag.size() - suffix.size(), suffix.size(), suffix) == 0)
      return tag.substr(0, tag.size() - suffix.size());
  }
  return "";
}

}  // namespace

AbstractOptimizationAlgorithmCreator::AbstractOptimizationAlgorithmCreator(
    const OptimizationAlgorithmProperty& p)
    : _property(p) {}
AbstractOptimizationAlgorithmCreator::~AbstractOptimizationAlgorithmCreator() = default;

OptimizationAlgorithmFactory::OptimizationAlgorithmFactory() = default;
OptimizationAlgorithmFactory::~OptimizationAlgorithmFactory() = default;

OptimizationAlgorithmFactory* OptimizationAlgorithmFactory::instance() {
  if (factory_slot() == nullptr) factory_slot() = new OptimizationAlgorithmFactory;
  return factory_slot();
}

void OptimizationAlgorithmFactory::destroy() {
  delete factory_slot();
  factory_slot() = nullptr;
}

void OptimizationAlgorithmFactory::registerSolver(
    const std::shared_ptr<AbstractOptimizationAlgorithmCreator>& c) {
  if (c == nullptr) return;
  const std::string& name = c->property().name;
  if (const auto found = findSolver(name); found != _creator.end()) {
    shadowed_.replace(name, *found, c);
  } else {
    _creator.push_back(c);
  }
}

void OptimizationAlgorithmFactory::registerSolver(AbstractOptimizationAlgorithmCreator* c) {
  registerSolver(std::shared_ptr<AbstractOptimizationAlgorithmCreator>(c));
}

void OptimizationAlgorithmFactory::unregisterSolver(
    const std::shared_ptr<AbstractOptimizationAlgorithmCreator>& c) {
  if (c == nullptr) return;
  const auto found = findSolver(c->property().name);
  if (found == _creator.end()) return;
  shadowed_.take_back(c->property().name, *found, c);
  if (*found == nullptr) _creator.erase(found);
}

OptimizationAlgorithm* OptimizationAlgorithmFactory::construct(
    const std::string& tag, OptimizationAlgorithmProperty& solverProperty) const {
  auto found = findSolver(tag);
  if (found == _creator.end()) {
    found = findSolver(without_library(tag));
    if (found != _creator.end())
      G2O_WARN("{} is replaced by {}, because no library that provides it is linked or loaded", tag,
               (*found)->property().name);
  }
  if (found == _creator.end()) {
    G2O_WARN("no algorithm is registered under the name {}", tag);
    return nullptr;
  }
  solverProperty = (*found)->property();
  return (*found)->construct();
}

void OptimizationAlgorithmFactory::listSolvers(std::ostream& os) const {
  std::size_t width = 0;
  for (const auto& creator : _creator) width = std::max(width, creator->property().name.size());
  for (const auto& creator : _creator) {
    os << creator->property().name << std::string(width + 4 - creator->property().name.size(), ' ')
       << creator->property().desc << '\n';
  }
}

OptimizationAlgorithmFactory::CreatorList::const_iterator OptimizationAlgorithmFactory::findSolver(
    const std::string& name) const {
  return std::find_if(_creator.begin(), _creator.end(),
                      [&](const auto& creator) { return creator->property().name == name; });
}

OptimizationAlgorithmFactory::CreatorList::iterator OptimizationAlgorithmFactory::findSolver(
    const std::string& name) {
  return std::find_if(_creator.begin(), _creator.end(),
                      [&](const auto& creator) { return creator->property().name == name; });
}

}  // namespace g2o
