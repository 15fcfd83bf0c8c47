// SPDX-License-Identifier: BSD-3-Clause
// Functions over a graph, called before and after iterations, and functions over its elements, found by name
// and type.
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

/// Called with a graph. Returns itself if it succeeded, else nullptr.
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

/// Implements the action name() for elements of one type. Returns itself if it did something, else nullptr.
class G2O_CORE_API HyperGraphElementAction {
 public:
  struct G2O_CORE_API Parameters {
    virtual ~Parameters();
  };
  using HyperGraphElementActionPtr = std::shared_ptr<HyperGraphElementAction>;
  /// By typeid(T).name().
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

/// The actions with one name, for elements of several types.
class G2O_CORE_API HyperGraphElementActionCollection : public HyperGraphElementAction {
 public:
  explicit HyperGraphElementActionCollection(const std::string& name_);
  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      Parameters* parameters) override;
  HyperGraphElementAction* operator()(const HyperGraph::HyperGraphElement* element,
                                      Parameters* parameters) override;
  ActionMap& actionMap() { return _actionMap; }
  /// Returns false if the action has another name. Replaces the action for its type, if there is one, until
  /// it is unregistered.
  bool registerAction(const HyperGraphElementActionPtr& action);
  bool unregisterAction(const HyperGraphElementActionPtr& action);

 protected:
  ActionMap _actionMap;

 private:
  internal::Shadowed<HyperGraphElementAction> shadowed_;
};

/// All registered actions.
class G2O_CORE_API HyperGraphActionLibrary {
 public:
  static HyperGraphActionLibrary* instance();
  static void destroy();

  /// The collection with this name, or nullptr.
  HyperGraphElementAction* actionByName(const std::string& name);
  bool registerAction(const HyperGraphElementActionPtr& action);
  bool unregisterAction(const HyperGraphElementActionPtr& action);
  HyperGraphElementAction::ActionMap& actionMap() { return _actionMap; }

 protected:
  HyperGraphActionLibrary();
  ~HyperGraphActionLibrary();
  HyperGraphElementAction::ActionMap _actionMap;
};

/// Calls an action on all elements, or on those whose typeid name is typeName: vertices by id, then edges in
/// the order in which they were added. Does nothing if the action is nullptr, which actionByName() returns
/// for unknown names.
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

/// Writes elements as text for gnuplot: the action "writeGnuplot".
class G2O_CORE_API WriteGnuplotAction : public HyperGraphElementAction {
 public:
  struct G2O_CORE_API Parameters : public HyperGraphElementAction::Parameters {
    std::ostream* os = nullptr;
  };
  explicit WriteGnuplotAction(const std::string& typeName_);
};

/// Draws elements: the action "draw". The action for a type draws its elements, their user data, and the
/// caches of its vertices. Elements whose type has no action are not drawn.
///
/// Properties in the parameters set the appearance of each type: `<typeName>::SHOW` (bool, by default true),
/// and further properties of the type's action, such as `<typeName>::POINT_SIZE`. The first drawing creates
/// each missing property with its default. To set one earlier, create it before the first drawing:
///
///     parameters.makeProperty<g2o::BoolProperty>(std::string(typeid(Edge).name()) + "::SHOW", false);
class G2O_CORE_API DrawAction : public HyperGraphElementAction {
 public:
  class G2O_CORE_API Parameters : public HyperGraphElementAction::Parameters, public PropertyMap {
   public:
    Parameters();
    ~Parameters() override;
    /// The target. Nothing is drawn while it is nullptr. Not owned.
    Drawing* drawing = nullptr;
  };

  explicit DrawAction(const std::string& typeName_);
  ~DrawAction() override;

 protected:
  /// Points the property members at the properties of `params_`, and creates missing properties. Returns
  /// false if `params_` is not a DrawAction::Parameters or has no drawing. Must be called before every
  /// drawing.
  virtual bool refreshPropertyPtrs(HyperGraphElementAction::Parameters* params_);
  /// Draw the caches of a vertex or the user data of an element with the actions for their types.
  void drawCache(CacheContainer* caches, HyperGraphElementAction::Parameters* params_);
  void drawUserData(HyperGraph::Data* data, HyperGraphElementAction::Parameters* params_);

  /// Returns the property `name` of this type. If it does not exist, creates it with the value `otherwise`.
  float property(const std::string& name, float otherwise);

  Parameters* _previousParams = nullptr;  ///< those of the last refreshPropertyPtrs()
  BoolProperty* _show = nullptr;          ///< of _previousParams
};

namespace internal {

/// An action for a type, under the class name that it has in g2o. Forwards to `action`.
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
