// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/property.h"

namespace g2o {

BaseProperty::BaseProperty(const std::string& name) : _name(name) {}
BaseProperty::~BaseProperty() = default;

PropertyMap::PropertyMap() = default;
PropertyMap::~PropertyMap() {
  for (const auto& [name, property] : *this) delete property;
}

bool PropertyMap::addProperty(BaseProperty* p) {
  return p != nullptr && emplace(p->name(), p).second;
}

bool PropertyMap::eraseProperty(const std::string& name) {
  const auto found = find(name);
  if (found == end()) return false;
  delete found->second;
  erase(found);
  return true;
}

bool PropertyMap::updatePropertyFromString(const std::string& name, const std::string& value) {
  const auto found = find(name);
  return found != end() && found->second->fromString(value);
}

bool PropertyMap::updateMapFromString(const std::string& values) {
  bool ok = true;
  std::istringstream in(values);
  for (std::string assignment; std::getline(in, assignment, ',');) {
    const std::size_t sign = assignment.find('=');
    const auto trimmed = [](const std::string& text) {
      const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
      return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
    };
    if (trimmed(assignment).empty()) continue;
    ok =
        sign != std::string::npos &&
        updatePropertyFromString(trimmed(assignment.substr(0, sign)), trimmed(assignment.substr(sign + 1))) &&
        ok;
  }
  return ok;
}

void PropertyMap::writeToCSV(std::ostream& os) const {
  const char* separator = "";
  for (const auto& [name, property] : *this) {
    os << separator << name;
    separator = ",";
  }
  os << "\n";
  separator = "";
  for (const auto& [name, property] : *this) {
    os << separator << property->toString();
    separator = ",";
  }
  os << "\n";
}

}  // namespace g2o
