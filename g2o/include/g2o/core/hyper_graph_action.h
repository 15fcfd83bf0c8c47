// SPDX-License-Identifier: BSD-3-Clause
// Functions over a graph, called before and after iterations; and functions over its elements, found by name
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

/// Called with a graph; returns itself where it succeeded, else nullptr.
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

/// What an action called name() does to elements of one type. Returns itself where it did something, else
/// nullptr.
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

/// The actions of one name for elements of several types.
class G2O_CORE_API HyperGraphElementActionCollection : public HyperGraphElementAction {
 public:
  explicit HyperGraphElementActionCollection(const std::string& name_);
  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      Parameters* parameters) override;
  HyperGraphElementAction* operator()(const HyperGraph::HyperGraphElement* element,
                                      Parameters* parameters) override;
  ActionMap& actionMap() { return _actionMap; }
  /// False where the name is another. An action for a type that has one replaces it, until it is taken back.
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

  /// The collection of that name, or nullptr.
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
/// the order in which they were added. Without an action, as actionByName() returns for unknown names,
/// nothing happens.
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

/// Draws elements: the action "draw". An action of a type draws its elements, their user data and the caches
/// of vertices; whatever has no action is not drawn.
///
/// How it looks can be set by properties of the parameters, per type: `<typeName>::SHOW` (bool, true) and
/// what the action of the type knows, as `<typeName>::POINT_SIZE`. They are made when first drawn, and found
/// if they were made before:
///
///     parameters.makeProperty<g2o::BoolProperty>(std::string(typeid(Edge).name()) + "::SHOW", false);
class G2O_CORE_API DrawAction : public HyperGraphElementAction {
 public:
  class G2O_CORE_API Parameters : public HyperGraphElementAction::Parameters, public PropertyMap {
   public:
    Parameters();
    ~Parameters() override;
    /// Where to draw; nothing is drawn while it is nullptr. Not owned.
    Drawing* drawing = nullptr;
  };

  explicit DrawAction(const std::string& typeName_);
  ~DrawAction() override;

 protected:
  /// Lets the members for properties be those of `params_`, making what is missing. False where `params_` is
  /// no Parameters, or nothing can be drawn into it. To be called before every drawing.
  virtual bool refreshPropertyPtrs(HyperGraphElementAction::Parameters* params_);
  /// Draws the caches of a vertex, the user data of an element, by the actions of their types.
  void drawCache(CacheContainer* caches, HyperGraphElementAction::Parameters* params_);
  void drawUserData(HyperGraph::Data* data, HyperGraphElementAction::Parameters* params_);

  /// The number that this type's property `name` has, `otherwise` where there was none.
  float property(const std::string& name, float otherwise);

  Parameters* _previousParams = nullptr;  ///< those of the last refreshPropertyPtrs()
  BoolProperty* _show = nullptr;          ///< of _previousParams
};

namespace internal {

/// An action of a type under the class name that it has in g2o: does what `action` does.
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

/// Registers an action class, which has a default constructor.
#define G2O_REGISTER_ACTION(classname) static g2o::RegisterActionProxy<classname> g_action_proxy_##classname;

#endif  // G2O_HYPER_GRAPH_ACTION_H
