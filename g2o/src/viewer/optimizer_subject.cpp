// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/optimizer_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>
#include <utility>

#include "boxplus/base/error.h"
#include "g2o/core/estimate_propagator.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/robust_kernel_factory.h"
#include "g2o/stuff/timeutil.h"
#include "settings/parse_number.h"

namespace g2o {
namespace internal {
namespace {

constexpr const char* kNoTruth = "the estimates of this graph cannot be compared with a truth here";

using boxplus::InvalidArgument;
using boxplus::IterationRecord;
using boxplus::Setting;
using boxplus::Settings;
using boxplus::viewer::Listener;
using boxplus::viewer::Message;
using boxplus::viewer::Outcome;

std::vector<OptimizationAlgorithmProperty> algorithms() {
  std::vector<OptimizationAlgorithmProperty> all;
  for (const auto& creator : OptimizationAlgorithmFactory::instance()->creatorList())
    all.push_back(creator->property());
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return all;
}

std::vector<std::string> kernels() {
  std::vector<std::string> names;
  RobustKernelFactory::instance()->fillKnownKernels(names);
  std::sort(names.begin(), names.end());
  return names;
}

/// chi2 with robust kernels, of all edges that have all their vertices.
double robust_chi2(SparseOptimizer& optimizer) {
  double sum = 0;
  for (HyperGraph::Edge* each : optimizer.edges()) {
    auto* edge = static_cast<OptimizableGraph::Edge*>(each);
    if (edge->numUndefinedVertices() > 0 || edge->level() != 0) continue;
    edge->computeError();
    Vector3 rho(edge->chi2(), 1, 0);
    if (edge->robustKernel() != nullptr) edge->robustKernel()->robustify(edge->chi2(), rho);
    sum += rho[0];
  }
  return sum;
}

bool are_same(const boxplus::viewer::VertexGroup& a, const boxplus::viewer::VertexGroup& b) {
  return a.name == b.name && a.shape == b.shape && a.slots.size() == b.slots.size() && a.color == b.color;
}

bool are_same(const boxplus::viewer::LineGroup& a, const boxplus::viewer::LineGroup& b) {
  return a.name == b.name && a.role == b.role && a.count == b.count && a.color == b.color;
}

template <class T>
bool are_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return are_same(x, y); });
}

/// Whether frames of one structure belong to the other one, too.
bool are_same(const boxplus::viewer::Structure& a, const boxplus::viewer::Structure& b) {
  return a.dimension == b.dimension && are_same(a.vertices, b.vertices) &&
         are_same(a.line_groups, b.line_groups) && a.lines == b.lines && a.fixed == b.fixed;
}

/// The number in a text that a user typed.
template <class T>
T number_in(const std::string& name, const std::string& text) {
  T number{};
  if (!boxplus::parse_number(text, number))
    throw InvalidArgument(fmt::format("{}: expected a number, got '{}'", name, text));
  return number;
}

/// Passes iterations on to the listener.
class Report final : public HyperGraphAction {
 public:
  Report(SparseOptimizer& optimizer, Listener& listener, bool& stop)
      : rows_(optimizer), listener_(listener), stop_(stop) {}

  HyperGraphAction* operator()(const HyperGraph* /*graph*/, Parameters* parameters) override {
    const auto* iteration = dynamic_cast<ParametersIteration*>(parameters);
    records.push_back(rows_.next(iteration == nullptr ? 0 : iteration->iteration));
    stop_ = !listener_.note(records.back()) || listener_.stop_flag();
    return this;
  }

  std::vector<IterationRecord> records;

 private:
  IterationRows rows_;
  Listener& listener_;
  bool& stop_;
};

}  // namespace

IterationRows::IterationRows(SparseOptimizer& optimizer)
    : optimizer_(optimizer), chi2_(robust_chi2(optimizer)), begin_s_(get_monotonic_time()) {}

IterationRecord IterationRows::next(int iteration) {
  IterationRecord record;
  record.iteration = iteration + 1;
  record.chi2 = optimizer_.activeRobustChi2();
  record.chi2_decrease = std::exchange(chi2_, record.chi2) - record.chi2;
  record.tries = 1;
  record.time_s = get_monotonic_time() - begin_s_;
  if (auto* levenberg = dynamic_cast<OptimizationAlgorithmLevenberg*>(optimizer_.solver())) {
    record.lambda = levenberg->currentLambda();
    record.tries = levenberg->levenbergIteration();
  }
  return record;
}

OptimizerSubject::OptimizerSubject(SparseOptimizer& optimizer, std::string name)
    : optimizer_(&optimizer), name_(std::move(name)) {
  std::ignore = update_structure();
}

OptimizerSubject::OptimizerSubject(std::unique_ptr<SparseOptimizer> optimizer, std::string name)
    : own_(std::move(optimizer)), optimizer_(own_.get()), name_(std::move(name)) {
  std::ignore = update_structure();
}

boxplus::viewer::Subject::Facts OptimizerSubject::facts() const {
  return {name_,   "g2o", optimizer_->vertices().size(), optimizer_->edges().size(), structure_.dimension,
          kNoTruth};
}

double OptimizerSubject::chi2() {
  return robust_chi2(*optimizer_);
}

bool OptimizerSubject::update_structure() {
  drawing_ = std::make_unique<RecordedDrawing>(*optimizer_);
  boxplus::viewer::Structure structure = drawing_->structure();
  if (structure_.count > 0) structure.center = structure_.center;
  const bool is_new = !are_same(structure, structure_);
  if (is_new) structure_ = std::move(structure);
  return is_new;
}

Message OptimizerSubject::structure(std::uint64_t graph, std::uint64_t number) const {
  return structure_message(structure_, graph, number);
}

std::string OptimizerSubject::describe(const boxplus::viewer::ElementName& /*name*/,
                                       std::uint64_t /*structure*/) const {
  throw InvalidArgument("the shapes of drawing actions are not described");
}

std::string OptimizerSubject::edit(const boxplus::viewer::Edit& /*edit*/) {
  throw InvalidArgument("the elements of this graph cannot be edited here");
}

Message OptimizerSubject::frame(const boxplus::viewer::FrameFacts& facts, bool /*at_rest*/) const {
  return frame_message(facts, structure_, drawing_->positions(structure_.center), {});
}

Message OptimizerSubject::uncertain_frame(const boxplus::viewer::FrameFacts& facts,
                                          Listener& /*listener*/) const {
  const boxplus::viewer::Uncertainty none{.note = "the shapes of drawing actions have no covariances"};
  return frame_message(facts, structure_, drawing_->positions(structure_.center), {}, none);
}

void OptimizerSubject::open_truth(const std::string& /*name*/, const std::string& /*text*/,
                                  Listener& /*listener*/) {
  throw InvalidArgument(kNoTruth);
}

std::string OptimizerSubject::diagnosis(std::uint64_t /*structure*/,
                                        const std::atomic<bool>& /*stop*/) const {
  throw InvalidArgument("this graph cannot be diagnosed here");
}

Message OptimizerSubject::pattern(const std::atomic<bool>& /*stop*/) const {
  throw InvalidArgument("the pattern of this graph is not known here");
}

// ---- Settings ----

std::vector<Setting> OptimizerSubject::settings() const {
  const auto setting = [](const char* name, const char* group, Setting::Kind kind, const char* help) {
    Setting made;
    made.name = name;
    made.group = group;
    made.kind = kind;
    made.help = help;
    return made;
  };
  Setting start = setting("start", "Method", Setting::Kind::kChoice, "The initial estimates");
  start.words = {"current", "odometry", "spanning-tree"};
  start.default_text = "current";
  Setting algorithm = setting("algorithm", "Method", Setting::Kind::kChoice,
                              "The algorithm and its linear solver, as in -listSolvers of the tool g2o");
  for (const OptimizationAlgorithmProperty& property : algorithms()) algorithm.words.push_back(property.name);
  algorithm.default_text = Choice().algorithm;
  Setting kernel = setting("kernel", "Outliers", Setting::Kind::kKernel,
                           "Robust kernel, which gives less weight to outliers");
  kernel.words = kernels();
  Setting width = setting("kernel-width", "Outliers", Setting::Kind::kNumber,
                          "The error, in standard deviations, above which the kernel reduces weights");
  width.needed_setting = "kernel";
  Setting scope = setting("kernel-on", "Outliers", Setting::Kind::kChoice,
                          "The edges that get the kernel; loop closures are edges between vertices whose ids "
                          "are not consecutive");
  scope.words = {"all", "loop-closures"};
  scope.default_text = "all";
  scope.needed_setting = "kernel";
  Setting iterations = setting("iterations", "Stop", Setting::Kind::kWholeNumber, "The number of iterations");
  iterations.default_text = std::to_string(Choice().iterations);
  return {start, algorithm, kernel, width, scope, iterations};
}

Message OptimizerSubject::form() const {
  const auto all = algorithms();
  return boxplus::viewer::form_message(
      {{"g2o", ".g2o"}}, settings(), [&](const Setting& setting, std::string_view word) {
        if (setting.name != "algorithm") return std::string();
        const auto property =
            std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == word; });
        if (property == all.end() || optimizer_->isSolverSuitable(*property)) return std::string();
        return fmt::format("needs poses with {} and landmarks with {} dimensions", property->poseDim,
                           property->landmarkDim);
      });
}

OptimizerSubject::Choice OptimizerSubject::choice_of(const Settings& values) const {
  Choice choice;
  const std::vector<Setting> table = settings();
  for (const auto& [name, value] : values) {
    const auto known =
        std::find_if(table.begin(), table.end(), [&key = name](const Setting& s) { return s.name == key; });
    if (known == table.end()) throw InvalidArgument(fmt::format("settings: '{}' is unknown", name));
    const bool is_word = std::find(known->words.begin(), known->words.end(), value) != known->words.end();
    if (!known->words.empty() && !is_word)
      throw InvalidArgument(fmt::format("{}: there is no '{}'", name, value));
    if (name == "algorithm") choice.algorithm = value;
    if (name == "kernel") choice.kernel = value;
    if (name == "start") choice.start = value;
    if (name == "kernel-on") choice.only_closures = value == "loop-closures";
    if (name == "iterations") choice.iterations = number_in<int>(name, value);
    if (name == "kernel-width") choice.kernel_width = number_in<double>(name, value);
  }
  if (choice.iterations < 0 || choice.iterations > boxplus::kMostIterations)
    throw InvalidArgument(fmt::format("iterations: expected 0 to {}", boxplus::kMostIterations));
  if (choice.kernel_width && !(*choice.kernel_width > 0))
    throw InvalidArgument("kernel-width: expected a positive number");
  return choice;
}

void OptimizerSubject::check(const Settings& values) const {
  std::ignore = choice_of(values);
}

// ---- Work ----

Outcome OptimizerSubject::run(const Settings& values, Listener& listener) {
  return iterate(choice_of(values), listener);
}

Outcome OptimizerSubject::step(const Settings& values, Listener& listener) {
  Choice choice = choice_of(values);
  choice.iterations = 1;
  choice.start = "current";
  return iterate(choice, listener);
}

/// Returns false if there is no such algorithm, or if it does not support the graph.
bool OptimizerSubject::use_algorithm(const std::string& name) {
  const bool keeps_own = name.empty() && optimizer_->algorithm() != nullptr;
  if (keeps_own || (!name.empty() && name == algorithm_ && optimizer_->algorithm() != nullptr)) return true;
  OptimizationAlgorithmProperty property;
  const std::string wanted = name.empty() ? "lm_var" : name;
  OptimizationAlgorithm* algorithm = OptimizationAlgorithmFactory::instance()->construct(wanted, property);
  if (algorithm == nullptr) return false;
  optimizer_->setAlgorithm(algorithm);
  algorithm_ = wanted;
  const int largest = optimizer_->maxDimension();
  for (const auto& [id, each] : optimizer_->vertices()) {
    auto* vertex = static_cast<OptimizableGraph::Vertex*>(each);
    vertex->setMarginalized(property.requiresMarginalize && vertex->dimension() < largest);
  }
  return optimizer_->isSolverSuitable(property);
}

/// Sets the kernels that a run wants, and removes those of the last run.
void OptimizerSubject::set_kernels(const Choice& choice) {
  if (!has_kernels_ && choice.kernel.empty()) return;
  has_kernels_ = !choice.kernel.empty();
  const auto creator = RobustKernelFactory::instance()->creator(choice.kernel);
  for (HyperGraph::Edge* each : optimizer_->edges()) {
    auto* edge = static_cast<OptimizableGraph::Edge*>(each);
    const bool is_closure = edge->vertices().size() < 2 || edge->numUndefinedVertices() > 0 ||
                            std::abs(edge->vertex(0)->id() - edge->vertex(1)->id()) != 1;
    RobustKernel* kernel =
        creator == nullptr || (choice.only_closures && !is_closure) ? nullptr : creator->construct();
    if (kernel != nullptr && choice.kernel_width) kernel->setDelta(*choice.kernel_width);
    edge->setRobustKernel(kernel);
  }
}

void OptimizerSubject::make_guess(const std::string& start) {
  if (start == "odometry") {
    EstimatePropagatorCostOdometry odometry(optimizer_);
    optimizer_->computeInitialGuess(odometry);
  } else if (start == "spanning-tree") {
    optimizer_->computeInitialGuess();
  }
}

Outcome OptimizerSubject::iterate(const Choice& choice, Listener& listener) {
  if (!use_algorithm(choice.algorithm))
    throw InvalidArgument(fmt::format("the algorithm {} does not support this graph", algorithm_));
  set_kernels(choice);
  if (!optimizer_->initializeOptimization())
    throw InvalidArgument("there is nothing to optimize: no edge has a free vertex");
  make_guess(choice.start);
  optimizer_->computeActiveErrors();
  const double before = optimizer_->activeRobustChi2();
  bool stop = false;
  bool* const flag = optimizer_->forceStopFlag();
  Report report(*optimizer_, listener, stop);
  optimizer_->setForceStopFlag(&stop);
  optimizer_->addPostIterationAction(&report);
  const int done = optimizer_->optimize(choice.iterations);
  optimizer_->removePostIterationAction(&report);
  optimizer_->setForceStopFlag(flag);
  optimizer_->computeActiveErrors();
  Outcome outcome;
  outcome.chi2 = optimizer_->activeRobustChi2();
  outcome.rows = std::move(report.records);
  outcome.converged = done > 0 || choice.iterations == 0;
  outcome.status = stop ? "stopped" : outcome.converged ? "ended" : "failed";
  outcome.headline = fmt::format("{}: chi2 {:.9g} → {:.9g} in {} iteration{}", outcome.status, before,
                                 outcome.chi2, outcome.rows.size(), outcome.rows.size() == 1 ? "" : "s");
  outcome.summary = outcome.headline;
  outcome.reason = outcome.converged ? "the last iteration was carried out" : "the last iteration failed";
  return outcome;
}

bool OptimizerSubject::guess(const std::string& start, Listener& listener) {
  if (!optimizer_->initializeOptimization()) {
    listener.log("warning", "no initial guess was made: no edge has a free vertex");
    return false;
  }
  make_guess(start);
  std::ignore = update_structure();
  listener.log("info", fmt::format("the initial guess {} has chi2 {:.9g}", start, chi2()));
  return true;
}

void OptimizerSubject::keep_estimates() {
  optimizer_->OptimizableGraph::push();  // of all vertices, not only of the active ones
}

void OptimizerSubject::drop_estimates() {
  optimizer_->OptimizableGraph::discardTop();
}

void OptimizerSubject::restore() {
  set_kernels({});
  optimizer_->OptimizableGraph::pop();
  optimizer_->OptimizableGraph::push();
}

std::string OptimizerSubject::formatted(const std::string& /*format*/) const {
  std::ostringstream text;
  if (!optimizer_->save(text))
    throw InvalidArgument("the graph has elements without a tag, so it cannot be saved");
  return text.str();
}

}  // namespace internal
}  // namespace g2o
