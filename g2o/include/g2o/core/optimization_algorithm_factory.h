// SPDX-License-Identifier: BSD-3-Clause
// Creates algorithms by name: "gn_var", "lm_fix6_3", …
#pragma once
#ifndef G2O_OPTMIZATION_ALGORITHM_FACTORY_H
#define G2O_OPTMIZATION_ALGORITHM_FACTORY_H

#include <iosfwd>
#include <list>
#include <memory>
#include <string>

#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/optimization_algorithm_property.h"
#include "g2o/core/shadowed.h"
#include "g2o/stuff/misc.h"

namespace g2o {

class G2O_CORE_API AbstractOptimizationAlgorithmCreator {
 public:
  explicit AbstractOptimizationAlgorithmCreator(const OptimizationAlgorithmProperty& p);
  virtual ~AbstractOptimizationAlgorithmCreator();
  /// Returns a new algorithm. The caller owns it.
  virtual OptimizationAlgorithm* construct() = 0;
  const OptimizationAlgorithmProperty& property() const { return _property; }

 protected:
  OptimizationAlgorithmProperty _property;
};

class G2O_CORE_API OptimizationAlgorithmFactory {
 public:
  using CreatorList = std::list<std::shared_ptr<AbstractOptimizationAlgorithmCreator>>;

  static OptimizationAlgorithmFactory* instance();
  static void destroy();

  /// If the name is already registered, `c` replaces the registered creator until `c` is withdrawn.
  void registerSolver(const std::shared_ptr<AbstractOptimizationAlgorithmCreator>& c);
  void registerSolver(AbstractOptimizationAlgorithmCreator* c);
  void unregisterSolver(const std::shared_ptr<AbstractOptimizationAlgorithmCreator>& c);
  /// Returns a new algorithm, which the caller owns, and sets `solverProperty`. Returns nullptr if the name
  /// is unknown. If the name ends in _cholmod or _csparse and that library is missing, logs a warning and
  /// returns the algorithm with the same name without this suffix.
  OptimizationAlgorithm* construct(const std::string& tag,
                                   OptimizationAlgorithmProperty& solverProperty) const;
  void listSolvers(std::ostream& os) const;
  const CreatorList& creatorList() const { return _creator; }

 protected:
  OptimizationAlgorithmFactory();
  ~OptimizationAlgorithmFactory();
  CreatorList::const_iterator findSolver(const std::string& name) const;
  CreatorList::iterator findSolver(const std::string& name);

  CreatorList _creator;

 private:
  internal::Shadowed<AbstractOptimizationAlgorithmCreator> shadowed_;
};

class RegisterOptimizationAlgorithmProxy {
 public:
  explicit RegisterOptimizationAlgorithmProxy(AbstractOptimizationAlgorithmCreator* c) : _creator(c) {
    OptimizationAlgorithmFactory::instance()->registerSolver(_creator);
  }
  ~RegisterOptimizationAlgorithmProxy() {
    OptimizationAlgorithmFactory::instance()->unregisterSolver(_creator);
  }
  RegisterOptimizationAlgorithmProxy(const RegisterOptimizationAlgorithmProxy&) = delete;
  RegisterOptimizationAlgorithmProxy& operator=(const RegisterOptimizationAlgorithmProxy&) = delete;

 private:
  std::shared_ptr<AbstractOptimizationAlgorithmCreator> _creator;
};

}  // namespace g2o

#define G2O_OAF_EXPORT G2O_API_EXPORT

/// Gives the algorithms of a library a group name. A program that contains G2O_USE_OPTIMIZATION_LIBRARY()
/// with this name links the algorithms, even if it does not use them directly.
#define G2O_REGISTER_OPTIMIZATION_LIBRARY(libraryname) \
  extern "C" void G2O_OAF_EXPORT g2o_optimization_library_##libraryname(void) {}

#define G2O_USE_OPTIMIZATION_LIBRARY(libraryname)                                 \
  extern "C" void g2o_optimization_library_##libraryname(void);                   \
  static g2o::ForceLinker g2o_force_optimization_algorithm_library_##libraryname( \
      g2o_optimization_library_##libraryname);

/// Registers an algorithm: G2O_REGISTER_OPTIMIZATION_ALGORITHM(gn_mine, new MyCreator(property)).
#define G2O_REGISTER_OPTIMIZATION_ALGORITHM(optimizername, instance)                 \
  extern "C" void G2O_OAF_EXPORT g2o_optimization_algorithm_##optimizername(void) {} \
  static g2o::RegisterOptimizationAlgorithmProxy g_optimization_algorithm_proxy_##optimizername(instance);

#define G2O_USE_OPTIMIZATION_ALGORITHM(optimizername)                            \
  extern "C" void g2o_optimization_algorithm_##optimizername(void);              \
  static g2o::ForceLinker g2o_force_optimization_algorithm_link_##optimizername( \
      g2o_optimization_algorithm_##optimizername);

#endif  // G2O_OPTMIZATION_ALGORITHM_FACTORY_H
