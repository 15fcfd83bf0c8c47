// SPDX-License-Identifier: BSD-3-Clause
// The registry of element types. Each type has a tag that identifies it in files.
#pragma once
#ifndef G2O_FACTORY_H
#define G2O_FACTORY_H

#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "g2o/core/creators.h"
#include "g2o/core/g2o_core_api.h"
#include "g2o/core/hyper_graph.h"
#include "g2o/core/shadowed.h"
#include "g2o/stuff/logger.h"
#include "g2o/stuff/misc.h"

namespace g2o {

/// Creates elements by the tag of their type. Each type has one tag. If a second type is registered with the
/// same tag, or a second tag for the same type, the factory rejects the registration and logs an error. A
/// type may be registered again with its own tag, for example by another copy of a library. The second
/// registration takes effect when the first registration is withdrawn.
class G2O_CORE_API Factory {
 public:
  static Factory* instance();
  static void destroy();

  void registerType(const std::string& tag, const std::shared_ptr<AbstractHyperGraphElementCreator>& c);
  /// For clients that pass a raw pointer. The factory takes ownership.
  void registerType(const std::string& tag, AbstractHyperGraphElementCreator* c);
  void unregisterType(const std::string& tag);
  /// Withdraws only the registration that was made with this creator. g2o does not have this overload.
  void unregisterType(const std::string& tag, const std::shared_ptr<AbstractHyperGraphElementCreator>& c);
  /// Returns a new element, which the caller owns. Returns nullptr if the tag is unknown or if
  /// `elemsToConstruct` does not contain the kind of the element.
  HyperGraph::HyperGraphElement* construct(const std::string& tag) const;
  HyperGraph::HyperGraphElement* construct(const std::string& tag,
                                           const HyperGraph::GraphElemBitset& elemsToConstruct) const;
  /// `elementType` receives the HyperGraph::HyperGraphElementType, or −1 if the tag is unknown.
  bool knowsTag(const std::string& tag, int* elementType = nullptr) const;
  /// Returns the tag of the type of an element, or an empty string if the type is not registered.
  const std::string& tag(const HyperGraph::HyperGraphElement* v) const;
  void fillKnownTypes(std::vector<std::string>& types) const;
  void printRegisteredTypes(std::ostream& os, bool comment = false) const;

 protected:
  struct CreatorInformation {
    std::shared_ptr<AbstractHyperGraphElementCreator> creator;
    int elementTypeBit = -1;
  };
  using CreatorMap = std::map<std::string, std::unique_ptr<CreatorInformation>>;
  using TagLookup = std::map<std::string, std::string>;

  Factory();
  ~Factory();

  CreatorMap _creator;   ///< creators by tag
  TagLookup _tagLookup;  ///< tags by typeid(T).name()

 private:
  internal::Shadowed<AbstractHyperGraphElementCreator> shadowed_;
};

template <typename T>
class RegisterTypeProxy {
 public:
  explicit RegisterTypeProxy(const std::string& name)
      : _name(name), _creator(std::make_shared<HyperGraphElementCreator<T>>()) {
    Factory::instance()->registerType(_name, _creator);
  }
  ~RegisterTypeProxy() { Factory::instance()->unregisterType(_name, _creator); }
  RegisterTypeProxy(const RegisterTypeProxy&) = delete;
  RegisterTypeProxy& operator=(const RegisterTypeProxy&) = delete;

 private:
  std::string _name;
  std::shared_ptr<AbstractHyperGraphElementCreator> _creator;
};

namespace internal {

constexpr bool isValidTag(const char* text) {
  if (*text == '\0') return false;
  for (; *text != '\0'; ++text) {
    if (*text == ' ' || (*text >= '\t' && *text <= '\r')) return false;
  }
  return true;
}

}  // namespace internal
}  // namespace g2o

#define G2O_FACTORY_EXPORT G2O_API_EXPORT

/// Registers a type and its tag for files: G2O_REGISTER_TYPE_NAME("VERTEX_SE2", VertexSE2). If the tag is an
/// identifier, G2O_REGISTER_TYPE(VERTEX_SE2, VertexSE2) does the same.
#define G2O_REGISTER_TYPE_NAME(name, classname)                                                             \
  static_assert(g2o::internal::isValidTag(name), "the tag of a type must not be empty or have whitespace"); \
  extern "C" void G2O_FACTORY_EXPORT g2o_type_##classname(void) {}                                          \
  static g2o::RegisterTypeProxy<classname> g_type_proxy_##classname(name);
#define G2O_REGISTER_TYPE(name, classname) G2O_REGISTER_TYPE_NAME(#name, classname)

#define G2O_USE_TYPE_BY_CLASS_NAME(classname) \
  extern "C" void g2o_type_##classname(void); \
  static g2o::ForceLinker proxy_##classname(g2o_type_##classname);

/// Gives the types of a library a group name. A program that contains G2O_USE_TYPE_GROUP() with this name
/// links the types, even if it does not use them directly.
#define G2O_REGISTER_TYPE_GROUP(type_group_name) \
  extern "C" void G2O_FACTORY_EXPORT g2o_type_group_##type_group_name(void) {}

#define G2O_USE_TYPE_GROUP(type_group_name)               \
  extern "C" void g2o_type_group_##type_group_name(void); \
  static g2o::ForceLinker g2o_force_type_link_##type_group_name(g2o_type_group_##type_group_name);

#endif  // G2O_FACTORY_H
