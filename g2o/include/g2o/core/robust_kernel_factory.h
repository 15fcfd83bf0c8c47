// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_ROBUST_KERNEL_FACTORY_H
#define G2O_ROBUST_KERNEL_FACTORY_H

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "g2o/core/robust_kernel.h"
#include "g2o/core/shadowed.h"
#include "g2o/stuff/misc.h"

namespace g2o {

class G2O_CORE_API AbstractRobustKernelCreator {
 public:
  virtual ~AbstractRobustKernelCreator() = default;
  virtual RobustKernel* construct() = 0;
  using Ptr = std::shared_ptr<AbstractRobustKernelCreator>;
};

template <typename T>
class RobustKernelCreator : public AbstractRobustKernelCreator {
 public:
  RobustKernel* construct() override { return new T; }
};

/// Creates robust kernels by name: "Huber", "Cauchy", …
class G2O_CORE_API RobustKernelFactory {
 public:
  static RobustKernelFactory* instance();
  static void destroy();

  /// If the name is already registered, `c` replaces the registered creator until `c` is withdrawn.
  void registerRobustKernel(const std::string& tag, const AbstractRobustKernelCreator::Ptr& c);
  /// For clients that pass a raw pointer. The factory takes ownership.
  void registerRobustKernel(const std::string& tag, AbstractRobustKernelCreator* c);
  void unregisterType(const std::string& tag);
  /// Withdraws only the registration that was made with this creator. g2o does not have this overload.
  void unregisterType(const std::string& tag, const AbstractRobustKernelCreator::Ptr& c);
  /// Returns a new kernel, which the caller owns, or nullptr if the name is unknown.
  RobustKernel* construct(const std::string& tag) const;
  AbstractRobustKernelCreator::Ptr creator(const std::string& tag) const;
  void fillKnownKernels(std::vector<std::string>& types) const;

 protected:
  using CreatorMap = std::map<std::string, AbstractRobustKernelCreator::Ptr>;
  RobustKernelFactory();
  ~RobustKernelFactory();
  CreatorMap _creator;

 private:
  internal::Shadowed<AbstractRobustKernelCreator> shadowed_;
};

template <typename T>
class RegisterRobustKernelProxy {
 public:
  explicit RegisterRobustKernelProxy(const std::string& name)
      : _name(name), _creator(std::make_shared<RobustKernelCreator<T>>()) {
    RobustKernelFactory::instance()->registerRobustKernel(_name, _creator);
  }
  ~RegisterRobustKernelProxy() { RobustKernelFactory::instance()->unregisterType(_name, _creator); }
  RegisterRobustKernelProxy(const RegisterRobustKernelProxy&) = delete;
  RegisterRobustKernelProxy& operator=(const RegisterRobustKernelProxy&) = delete;

 private:
  std::string _name;
  AbstractRobustKernelCreator::Ptr _creator;
};

}  // namespace g2o

#define G2O_REGISTER_ROBUST_KERNEL(name, classname)                     \
  extern "C" void g2o_robust_kernel_##classname(void);                  \
  extern "C" G2O_API_EXPORT void g2o_robust_kernel_##classname(void) {} \
  static g2o::RegisterRobustKernelProxy<classname> g_robust_kernel_proxy_##classname(#name);

#define G2O_USE_ROBUST_KERNEL(classname)               \
  extern "C" void g2o_robust_kernel_##classname(void); \
  static g2o::ForceLinker g2o_force_robust_kernel_link_##classname(g2o_robust_kernel_##classname);

#endif  // G2O_ROBUST_KERNEL_FACTORY_H
