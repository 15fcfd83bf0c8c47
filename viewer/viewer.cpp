// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/viewer/viewer.h"

#include <utility>

#include "viewer/server/server.h"
#include "viewer/workspace/workspace.h"

namespace boxplus {

class Viewer::Implementation {
 public:
  Implementation(Graph& graph, const ViewerOptions& options)
      : workspace_(nullptr), server_(workspace_, {options.host, options.port}) {
    workspace_.show(std::make_unique<viewer::GraphSubject>(graph, options.name));
    workspace_.hold();
  }

  viewer::Workspace& workspace() { return workspace_; }
  std::string url() const { return server_.url(); }

 private:
  viewer::Workspace workspace_;
  viewer::Server server_;
};

Viewer::Viewer(Graph& graph, const ViewerOptions& options)
    : implementation_(std::make_unique<Implementation>(graph, options)) {}
Viewer::~Viewer() = default;

std::string Viewer::url() const {
  return implementation_->url();
}

Options Viewer::watch(Options options) {
  take_back();
  options.callback = [&workspace = implementation_->workspace(),
                      next = std::move(options.callback)](const IterationRecord& record) {
    const bool goes_on = workspace.watch(record);
    return (!next || next(record)) && goes_on;
  };
  return options;
}

void Viewer::show(const Report& report) {
  take_back();
  implementation_->workspace().watch_end(viewer::outcome_of(report));
}

void Viewer::show(const OutlierReport& found) {
  take_back();
  implementation_->workspace().watch_end(viewer::outcome_of(found));
}

void Viewer::update() {
  take_back();
  implementation_->workspace().update();
}

void Viewer::follow() {
  take_back();
  implementation_->workspace().follow();
}

void Viewer::hand_over() {
  implementation_->workspace().hand_over();
}

void Viewer::take_back() {
  implementation_->workspace().hold();
}

}  // namespace boxplus
