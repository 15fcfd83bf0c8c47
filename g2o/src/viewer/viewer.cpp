// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/viewer/viewer.h"

#include <optional>

#include "g2o/core/hyper_graph_action.h"
#include "viewer/optimizer_subject.h"
#include "viewer/server/server.h"
#include "viewer/workspace/workspace.h"

namespace g2o {

class Viewer::Implementation final : public HyperGraphAction {
  /// Notes chi2 before the first iteration of a run.
  class Beginning final : public HyperGraphAction {
   public:
    explicit Beginning(Implementation& viewer) : viewer_(viewer) {}
    HyperGraphAction* operator()(const HyperGraph* /*graph*/, Parameters* parameters) override {
      const auto* iteration = dynamic_cast<ParametersIteration*>(parameters);
      if (iteration == nullptr || iteration->iteration == 0) viewer_.rows_.emplace(viewer_.optimizer_);
      return this;
    }

   private:
    Implementation& viewer_;
  };

 public:
  Implementation(SparseOptimizer& optimizer, int port, const std::string& name)
      : optimizer_(optimizer), workspace_(nullptr), server_(workspace_, {.port = port}) {
    workspace_.show(std::make_unique<internal::OptimizerSubject>(optimizer, name));
    takeBack();
  }
  ~Implementation() override {
    leave();
    if (optimizer_.forceStopFlag() == &stop_) optimizer_.setForceStopFlag(nullptr);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  HyperGraphAction* operator()(const HyperGraph* /*graph*/, Parameters* parameters) override {
    const auto* iteration = dynamic_cast<ParametersIteration*>(parameters);
    const int number = iteration == nullptr ? 0 : iteration->iteration;
    if (!rows_) rows_.emplace(optimizer_);
    bool* const flag = optimizer_.forceStopFlag();
    if (!workspace_.watch(rows_->next(number)) && flag != nullptr) *flag = true;
    return this;
  }

  std::string url() const { return server_.url(); }
  void update() {
    takeBack();
    workspace_.update();
    stop_ = false;
  }
  void handOver() {
    leave();  // a run of the page has an action of its own
    workspace_.hand_over();
  }
  void takeBack() {
    workspace_.hold();
    optimizer_.addPreIterationAction(&beginning_);
    optimizer_.addPostIterationAction(this);
    if (optimizer_.forceStopFlag() == nullptr) optimizer_.setForceStopFlag(&stop_);
  }

 private:
  void leave() {
    optimizer_.removePreIterationAction(&beginning_);
    optimizer_.removePostIterationAction(this);
  }

  SparseOptimizer& optimizer_;
  Beginning beginning_{*this};
  bool stop_ = false;
  std::optional<internal::IterationRows> rows_;
  boxplus::viewer::Workspace workspace_;
  boxplus::viewer::Server server_;
};

Viewer::Viewer(SparseOptimizer& optimizer, int port, const std::string& name)
    : _implementation(std::make_unique<Implementation>(optimizer, port, name)) {}
Viewer::~Viewer() = default;

std::string Viewer::url() const {
  return _implementation->url();
}

void Viewer::update() {
  _implementation->update();
}

void Viewer::handOver() {
  _implementation->handOver();
}

void Viewer::takeBack() {
  _implementation->takeBack();
}

}  // namespace g2o
