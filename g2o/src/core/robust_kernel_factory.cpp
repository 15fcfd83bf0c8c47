// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/robust_kernel_factory.h"

#include "g2o/core/robust_kernel_impl.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace {

RobustKernelFactory*& factory_slot() {
  static RobustKernelFactory* slot = nullptr;
  return slot;
}

template <class T>
AbstractRobustKernelCreator::Ptr creator_of() {
  return std::make_shared<RobustKernelCreator<T>>();
}

}  // namespace

// Registers the kernels of the library in the constructor, so that programs can find them by name even if
// they use no kernel class.
RobustKernelFactory::RobustKernelFactory()
    : _creator{{"Huber", creator_of<RobustKernelHuber>()},
               {"PseudoHuber", creator_of<RobustKernelPseudoHuber>()},
               {"Cauchy", creator_of<RobustKernelCauchy>()},
               {"GemanMcClure", creator_of<RobustKernelGemanMcClure>()},
               {"Welsch", creator_of<RobustKernelWelsch>()},
               {"Fair", creator_of<RobustKernelFair>()},
               {"Tukey", creator_of<RobustKernelTukey>()},
               {"Saturated", creator_of<RobustKernelSaturated>()},
               {"DCS", creator_of<RobustKernelDCS>()}} {}
RobustKernelFactory::~RobustKernelFactory() = default;

RobustKernelFactory* RobustKernelFactory::instance() {
  if (factory_slot() == nullptr) factory_slot() = new RobustKernelFactory;
  return factory_slot();
}

void RobustKernelFactory::destroy() {
  delete factory_slot();
  factory_slot() = nullptr;
}

void RobustKernelFactory::registerRobustKernel(const std::string& tag,
                                               const AbstractRobustKernelCreator::Ptr& c) {
  if (c == nullptr) {
    G2O_ERROR("registerRobustKernel: expected a creator for {}, got nullptr", tag);
    return;
  }
  shadowed_.replace(tag, _creator[tag], c);
}

void RobustKernelFactory::registerRobustKernel(const std::string& tag, AbstractRobustKernelCreator* c) {
  registerRobustKernel(tag, AbstractRobustKernelCreator::Ptr(c));
}

void RobustKernelFactory::unregisterType(const std::string& tag) {
  shadowed_.forget(tag);
  _creator.erase(tag);
}

void RobustKernelFactory::unregisterType(const std::string& tag, const AbstractRobustKernelCreator::Ptr& c) {
  const auto found = _creator.find(tag);
  if (found == _creator.end()) return;
  shadowed_.take_back(tag, found->second, c);
  if (found->second == nullptr) _creator.erase(found);
}

RobustKernel* RobustKernelFactory::construct(const std::string& tag) const {
  const auto found = _creator.find(tag);
  if (found != _creator.end()) return found->second->construct();
  G2O_WARN("no robust kernel is registered under the name {}", tag);
  return nullptr;
}

AbstractRobustKernelCreator::Ptr RobustKernelFactory::creator(const std::string& tag) const {
  const auto found = _creator.find(tag);
  return found == _creator.end() ? nullptr : found->second;
}

void RobustKernelFactory::fillKnownKernels(std::vector<std::string>& types) const {
  types.clear();
  for (const auto& [name, creator] : _creator) types.push_back(name);
}

}  // namespace g2o
