// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/factory.h"

#include <ostream>
#include <utility>

namespace g2o {

AbstractHyperGraphElementCreator::AbstractHyperGraphElementCreator() = default;
AbstractHyperGraphElementCreator::~AbstractHyperGraphElementCreator() = default;

namespace {

// The factory is not destroyed at exit, because static objects in plug-ins may still unregister themselves at
// that time.
Factory*& factory_slot() {
  static Factory* slot = nullptr;
  return slot;
}

}  // namespace

Factory::Factory() = default;
Factory::~Factory() = default;

Factory* Factory::instance() {
  if (factory_slot() == nullptr) factory_slot() = new Factory;
  return factory_slot();
}

void Factory::destroy() {
  delete factory_slot();
  factory_slot() = nullptr;
}

void Factory::registerType(const std::string& tag,
                           const std::shared_ptr<AbstractHyperGraphElementCreator>& c) {
  if (c == nullptr) return;
  if (const auto taken = _creator.find(tag); taken != _creator.end()) {
    if (taken->second->creator->name() == c->name()) {
      if (taken->second->creator != c) shadowed_.hide(tag, c);
    } else {
      G2O_ERROR("registerType: the tag {} is taken", tag);
    }
    return;
  }
  if (_tagLookup.count(c->name()) > 0) {
    G2O_ERROR("registerType: the type of {} is already registered as {}", tag, _tagLookup.at(c->name()));
    return;
  }
  const std::unique_ptr<HyperGraph::HyperGraphElement> sample(c->construct());
  auto information = std::make_unique<CreatorInformation>();
  information->creator = c;
  information->elementTypeBit = sample == nullptr ? -1 : static_cast<int>(sample->elementType());
  _tagLookup[c->name()] = tag;
  _creator[tag] = std::move(information);
}

void Factory::registerType(const std::string& tag, AbstractHyperGraphElementCreator* c) {
  registerType(tag, std::shared_ptr<AbstractHyperGraphElementCreator>(c));
}

void Factory::unregisterType(const std::string& tag) {
  const auto found = _creator.find(tag);
  if (found == _creator.end()) return;
  shadowed_.forget(tag);
  _tagLookup.erase(found->second->creator->name());
  _creator.erase(found);
}

void Factory::unregisterType(const std::string& tag,
                             const std::shared_ptr<AbstractHyperGraphElementCreator>& c) {
  const auto found = _creator.find(tag);
  if (found == _creator.end()) return;
  shadowed_.take_back(tag, found->second->creator, c);
  if (found->second->creator != nullptr) return;
  _tagLookup.erase(c->name());
  _creator.erase(found);
}

HyperGraph::HyperGraphElement* Factory::construct(const std::string& tag) const {
  const auto found = _creator.find(tag);
  if (found != _creator.end()) return found->second->creator->construct();
  G2O_WARN("no type is registered under the tag {}", tag);
  return nullptr;
}

HyperGraph::HyperGraphElement* Factory::construct(const std::string& tag,
                                                  const HyperGraph::GraphElemBitset& elemsToConstruct) const {
  if (elemsToConstruct.none()) return construct(tag);
  int kind = -1;
  const bool wanted = knowsTag(tag, &kind) && kind >= 0 && elemsToConstruct.test(static_cast<size_t>(kind));
  return wanted ? construct(tag) : nullptr;
}

bool Factory::knowsTag(const std::string& tag, int* elementType) const {
  const auto found = _creator.find(tag);
  if (elementType != nullptr) *elementType = found == _creator.end() ? -1 : found->second->elementTypeBit;
  return found != _creator.end();
}

const std::string& Factory::tag(const HyperGraph::HyperGraphElement* v) const {
  static const std::string kNone;
  if (v == nullptr) return kNone;
  const auto found = _tagLookup.find(typeid(*v).name());
  return found == _tagLookup.end() ? kNone : found->second;
}

void Factory::fillKnownTypes(std::vector<std::string>& types) const {
  types.clear();
  for (const auto& [tag, information] : _creator) types.push_back(tag);
}

void Factory::printRegisteredTypes(std::ostream& os, bool comment) const {
  const char* begin = comment ? "# " : "";
  os << begin << "types:\n";
  for (const auto& [tag, information] : _creator) os << begin << "\t" << tag << "\n";
}

}  // namespace g2o
