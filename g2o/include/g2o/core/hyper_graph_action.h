// SPDX-License-Identifier: BSD-3-Clause
// Two kinds of actions. A HyperGraphAction is called for a graph before or after each iteration. A
// HyperGraphElementAction is called for elements of a graph, for example to draw them. The library finds
// element actions by name and type.
#pragma once
#ifndef G2O_HYPER_GRAPH_ACTION_H
#define G2O_HYPER_GRAPH_ACTION_H

#include <iosfwd>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <typeinfo>
#include <utility>

#include "g2o/core/drawing.h"
#include "g2o/core/hyper_graph.h"
#include "g2o/core/shadowed.h"
#include "g2o/stuff/property.h"

namespace g2o {

class CacheContainer;

/// An action on a graph. operator() returns the action itself if it succeeded, otherwise nullptr.
class G2O_CORE_API HyperGraphAction {
 public:
  class G2O_CORE_API Parameters {
   public:
    virtual ~Parameters();
  };
  class G2O_CORE_API ParametersIteration : public Parameters {
   public:
    explicit ParametersIteration(int iter);
    ~ParametersIteration() override;
    int iteration;
  };

  virtual ~HyperGraphAction();
  virtual HyperGraphAction* operator()(const HyperGraph* graph, Parameters* parameters = nullptr);
};

/// An action on elements of one type. Actions of several types may have the same name(). operator() returns
/// the action itself if it did something, otherwise nullptr.
class G2O_CORE_API HyperGraphElementAction {
 public:
  struct G2O_CORE_API Parameters {
    virtual ~Parameters();
  };
  using HyperGraphElementActionPtr = std::shared_ptr<HyperGraphElementAction>;
  /// Maps typeid(T).name() to an action. The library uses the same type to map the name of an action to a
  /// collection.
  using ActionMap = std::map<std::string, HyperGraphElementActionPtr>;

  explicit HyperGraphElementAction(const std::string& typeName_ = "");
  virtual ~HyperGraphElementAction();
  virtual HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element, Parameters* parameters);
  virtual HyperGraphElementAction* operator()(const HyperGraph::HyperGraphElement* element,
                                              Parameters* parameters);

  const std::string& typeName() const { return _typeName; }
  const std::string& name() const { return _name; }
  void setTypeName(const std::string& typeName_);

 protected:
  std::string _typeName;
  std::string _name;
};

using HyperGraphElementActionPtr = HyperGraphElementAction::HyperGraphElementActionPtr;

/// All actions with the same name, for elements of several types.
class G2O_CORE_API HyperGraphElementActionCollection : public HyperGraphElementAction {
 public:
  explicit HyperGraphElementActionCollection(const std::string& name_);
  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      Parameters* parameters) override;
  HyperGraphElementAction* operator()(const HyperGraph::HyperGraphElement* element,
                                      Parameters* parameters) override;
  ActionMap& actionMap() { return _actionMap; }
  /// Returns false if the action has a different name. If its type already has an action, the new action
  /// replaces the old action until the new action is unregistered.
  bool registerAction(const HyperGraphElementActionPtr& action);
  bool unregisterAction(const HyperGraphElementActionPtr& action);

 protected:
  ActionMap _actionMap;

 private:
  internal::Shadowed<HyperGraphElementAction> shadowed_;
};

/// The collections of all registered actions.
class G2O_CORE_API HyperGraphActionLibrary {
 public:
  static HyperGraphActionLibrary* instance();
  static void destroy();

  /// Returns the collection of the actions with this name, or nullptr.
  HyperGraphElementAction* actionByName(const std::string& name);
  bool registerAction(const HyperGraphElementActionPtr& action);
  bool unregisterAction(const HyperGraphElementActionPtr& action);
  HyperGraphElementAction::ActionMap& actionMap() { return _actionMap; }

 protected:
  HyperGraphActionLibrary();
  ~HyperGraphActionLibrary();
  HyperGraphElementAction::ActionMap _actionMap;
};

/// Calls an action on all elements, or only on elements of the type whose typeid name is `typeName`. Visits
/// vertices by id, then edges in the order in which they were added. Does nothing if the action is nullptr
/// (actionByName() returns nullptr for unknown names).
G2O_CORE_API void applyAction(HyperGraph* graph, HyperGraphElementAction* action,
                              HyperGraphElementAction::Parameters* parameters = nullptr,
                              const std::string& typeName = "");

template <typename T>
class RegisterActionProxy {
 public:
  RegisterActionProxy() : _action(std::make_shared<T>()) {
    HyperGraphActionLibrary::instance()->registerAction(_action);
  }
  ~RegisterActionProxy() { HyperGraphActionLibrary::instance()->unregisterAction(_action); }
  RegisterActionProxy(const RegisterActionProxy&) = delete;
  RegisterActionProxy& operator=(const RegisterActionProxy&) = delete;

 private:
  HyperGraphElementActionPtr _action;
};

/// The base class of the actions "writeGnuplot", which write elements as text for gnuplot.
class G2O_CORE_API WriteGnuplotAction : public HyperGraphElementAction {
 public:
  struct G2O_CORE_API Parameters : public HyperGraphElementAction::Parameters {
    std::ostream* os = nullptr;
  };
  explicit WriteGnuplotAction(const std::string& typeName_);
};

/// The base class of the actions "draw". The action for a type draws the elements of the type, their user
/// data, and the caches of vertices. Elements whose type has no action are not drawn.
///
/// The parameters have properties that set the appearance of each type: `<typeName>::SHOW` (bool, true by
/// default) and further properties of the type's action, such as `<typeName>::POINT_SIZE`. The first drawing
/// creates each missing property with its default value. To set a value earlier, create the property:
///
///     parameters.makeProperty<g2o::BoolProperty>(std::string(typeid(Edge).name()) + "::SHOW", false);
class G2O_CORE_API DrawAction : public HyperGraphElementAction {
 public:
  class G2O_CORE_API Parameters : public HyperGraphElementAction::Parameters, public PropertyMap {
   public:
    Parameters();
    ~Parameters() override;
    /// The canvas, which the caller owns. If it is nullptr, nothing is drawn.
    Drawing* drawing = nullptr;
  };

  explicit DrawAction(const std::string& typeName_);
  ~DrawAction() override;

 protected:
  /// Finds the properties of this type in `params_`, creates missing properties, and stores pointers to them
  /// in members. Returns false if `params_` is not a DrawAction::Parameters or has no drawing. Call this
  /// function before you draw an element.
  virtual bool refreshPropertyPtrs(HyperGraphElementAction::Parameters* params_);
  /// Draw the caches of a vertex, or the user data of an element, with the actions for their types.
  void drawCache(CacheContainer* caches, HyperGraphElementAction::Parameters* params_);
  void drawUserData(HyperGraph::Data* data, HyperGraphElementAction::Parameters* params_);

  /// Returns the property `name` of this type. If it does not exist, creates it with the value `otherwise`.
  float property(const std::string& name, float otherwise);

  Parameters* _previousParams = nullptr;  ///< the parameters of the last refreshPropertyPtrs()
  BoolProperty* _show = nullptr;          ///< the property SHOW in _previousParams
};

namespace internal {

/// The base of action classes that exist because g2o has classes with these names. Forwards calls to
/// `action`.
template <class Base>
class NamedAction : public Base {
 public:
  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    return (*action_)(element, parameters) == nullptr ? nullptr : this;
  }
  HyperGraphElementAction* operator()(const HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    return (*action_)(element, parameters) == nullptr ? nullptr : this;
  }

 protected:
  explicit NamedAction(std::unique_ptr<HyperGraphElementAction> action)
      : Base(action->typeName()), action_(std::move(action)) {}

 private:
  std::unique_ptr<HyperGraphElementAction> action_;
};

}  // namespace internal
}  // namespace g2o

/// Registers an action class that has a default constructor.
#define G2O_REGISTER_ACTION(classname) static g2o::RegisterActionProxy<classname> g_action_proxy_##classname;

#endif  // G2O_HYPER_GRAPH_ACTION_H
