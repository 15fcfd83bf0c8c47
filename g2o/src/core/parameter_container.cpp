// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/parameter_container.h"

#include <memory>
#include <sstream>
#include <string>
#include <typeinfo>

#include "core/shortest_numbers.h"
#include "g2o/core/factory.h"
#include "g2o/core/ownership.h"
#include "g2o/stuff/logger.h"

namespace g2o {

Parameter::Parameter() = default;
Parameter::~Parameter() = default;

ParameterContainer::ParameterContainer(bool isMainStorage) : _isMainStorage(isMainStorage) {}

ParameterContainer::~ParameterContainer() {
  clear();
}

void ParameterContainer::clear() {
  if (_isMainStorage) {
    for (const auto& [id, p] : *this) release(p);
  }
  BaseClass::clear();
}

bool ParameterContainer::addParameter(Parameter* p) {
  if (p == nullptr || p->id() < 0) {
    G2O_ERROR("addParameter: expected a parameter with an id of at least 0, got {}",
              p == nullptr ? "nullptr" : std::to_string(p->id()));
    return false;
  }
  if (emplace(p->id(), p).second) return true;
  G2O_ERROR("addParameter: the id {} is taken", p->id());
  return false;
}

Parameter* ParameterContainer::getParameter(int id) const {
  const auto found = find(id);
  return found == end() ? nullptr : found->second;
}

Parameter* ParameterContainer::detachParameter(int id) {
  const auto found = find(id);
  if (found == end()) return nullptr;
  Parameter* p = found->second;
  erase(found);
  return p;
}

bool ParameterContainer::read(std::istream& is, const std::map<std::string, std::string>* renameMap) {
  HyperGraph::GraphElemBitset parameters;
  parameters.set(HyperGraph::HGET_PARAMETER);
  bool ok = true;
  for (std::string line; std::getline(is, line);) {
    std::istringstream fields(line);
    fields.imbue(std::locale::classic());
    std::string tag;
    if (!(fields >> tag) || tag[0] == '#') continue;
    if (renameMap != nullptr && renameMap->count(tag) > 0) tag = renameMap->at(tag);
    std::unique_ptr<HyperGraph::HyperGraphElement> element(Factory::instance()->construct(tag, parameters));
    auto* p = dynamic_cast<Parameter*>(element.get());
    if (p == nullptr) continue;
    int id = -1;
    fields >> id;
    p->setId(id);
    if (!p->read(fields) || !addParameter(p)) {
      G2O_ERROR("{} {}: the parameter cannot be read, or its id is taken", tag, id);
      ok = false;
      continue;
    }
    static_cast<void>(element.release());
  }
  return ok;
}

bool ParameterContainer::write(std::ostream& os) const {
  ShortestNumbers out(os);
  bool ok = true;
  for (const auto& [id, p] : *this) {
    const std::string& tag = Factory::instance()->tag(p);
    if (tag.empty()) {
      G2O_ERROR("save: no tag is registered for the type {}", typeid(*p).name());
      ok = false;
      continue;
    }
    out.stream() << tag << " " << id << " ";
    p->write(out.stream());
    out.stream() << '\n';
  }
  return ok && out.good();
}

}  // namespace g2o
