// SPDX-License-Identifier: BSD-3-Clause
// Named values that can be set from text.
#pragma once
#ifndef G2O_PROPERTY_H
#define G2O_PROPERTY_H
#define G2O_PROPERTY_H_  // the name in g2o, which clients test with #ifdef

#include <map>
#include <ostream>
#include <sstream>
#include <string>

#include "g2o/stuff/g2o_stuff_api.h"
#include "g2o/stuff/string_tools.h"

namespace g2o {

class G2O_STUFF_API BaseProperty {
 public:
  explicit BaseProperty(const std::string& name);
  virtual ~BaseProperty();
  const std::string& name() const { return _name; }
  virtual std::string toString() const = 0;
  /// Sets the value from text. Returns false and keeps the value if the text is invalid.
  virtual bool fromString(const std::string& s) = 0;

 protected:
  std::string _name;
};

template <typename T>
class Property : public BaseProperty {
 public:
  using ValueType = T;
  explicit Property(const std::string& name) : BaseProperty(name) {}
  Property(const std::string& name, const T& v) : BaseProperty(name), _value(v) {}
  void setValue(const T& v) { _value = v; }
  const T& value() const { return _value; }
  std::string toString() const override {
    std::ostringstream out;
    out << _value;
    return out.str();
  }
  bool fromString(const std::string& s) override {
    std::istringstream in(s);
    T value;
    if (!(in >> value)) return false;
    _value = value;
    return true;
  }

 protected:
  T _value{};
};

/// Owns properties and finds them by name.
class G2O_STUFF_API PropertyMap : protected std::map<std::string, BaseProperty*> {
 public:
  using BaseClass = std::map<std::string, BaseProperty*>;
  using PropertyMapIterator = BaseClass::iterator;
  using PropertyMapConstIterator = BaseClass::const_iterator;

  PropertyMap();
  PropertyMap(const PropertyMap&) = delete;
  PropertyMap& operator=(const PropertyMap&) = delete;
  ~PropertyMap();
  /// Takes ownership. If the name is taken, returns false, and the caller still owns the property.
  bool addProperty(BaseProperty* p);
  /// Deletes the property. Returns false if there is no property with this name.
  bool eraseProperty(const std::string& name);

  /// Returns the property with this name and type, or nullptr.
  template <typename P>
  P* getProperty(const std::string& name) {
    const auto found = find(name);
    return found == end() ? nullptr : dynamic_cast<P*>(found->second);
  }
  template <typename P>
  const P* getProperty(const std::string& name) const {
    const auto found = find(name);
    return found == end() ? nullptr : dynamic_cast<const P*>(found->second);
  }
  /// Returns the property with this name, which the map owns. Creates the property if it does not exist.
  /// Returns nullptr if a property of another type has this name.
  template <typename P>
  P* makeProperty(const std::string& name, const typename P::ValueType& v) {
    const auto found = find(name);
    if (found != end()) return dynamic_cast<P*>(found->second);
    P* made = new P(name, v);
    addProperty(made);
    return made;
  }

  /// Sets the property `name` from text. Returns false if the property does not exist or if the text is
  /// invalid.
  bool updatePropertyFromString(const std::string& name, const std::string& value);
  /// Sets properties from a string such as "name=value,name=value".
  bool updateMapFromString(const std::string& values);
  /// Writes a line of names and a line of values, separated by ", ".
  void writeToCSV(std::ostream& os) const;

  using BaseClass::begin;
  using BaseClass::const_iterator;
  using BaseClass::empty;
  using BaseClass::end;
  using BaseClass::iterator;
  using BaseClass::size;
};

using IntProperty = Property<int>;
using BoolProperty = Property<bool>;
using FloatProperty = Property<float>;
using DoubleProperty = Property<double>;
using StringProperty = Property<std::string>;

}  // namespace g2o

#endif  // G2O_PROPERTY_H
