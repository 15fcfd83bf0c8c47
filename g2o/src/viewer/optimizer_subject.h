// SPDX-License-Identifier: BSD-3-Clause
// A g2o::SparseOptimizer in the viewer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "g2o/core/optimization_algorithm_property.h"
#include "g2o/core/sparse_optimizer.h"
#include "settings/setting_table.h"
#include "viewer/recorded_drawing.h"
#include "viewer/workspace/subject.h"

namespace g2o {
namespace internal {

/// Settings: the algorithms and robust kernels of the factories, iterations, and the initial guess. The
/// actions "draw" make the picture.
class OptimizerSubject final : public boxplus::viewer::Subject {
 public:
  /// Shows an optimizer of the program, which must outlive this subject.
  OptimizerSubject(SparseOptimizer& optimizer, std::string name);
  /// Owns the optimizer.
  OptimizerSubject(std::unique_ptr<SparseOptimizer> optimizer, std::string name);

  Facts facts() const override;
  double chi2() override;
  boxplus::viewer::Message form() const override;
  bool update_structure() override;
  boxplus::viewer::Message structure(std::uint64_t graph, std::uint64_t number) const override;
  boxplus::viewer::Message frame(const boxplus::viewer::FrameFacts& facts, bool at_rest) const override;
  boxplus::viewer::Message uncertain_frame(const boxplus::viewer::FrameFacts& facts,
                                           boxplus::viewer::Listener& listener) const override;
  void open_truth(const std::string& name, const std::string& text,
                  boxplus::viewer::Listener& listener) override;
  boxplus::viewer::Message truth(std::uint64_t /*structure*/) override { return nullptr; }
  std::string describe(const boxplus::viewer::ElementName& name, std::uint64_t structure) const override;
  std::string edit(const boxplus::viewer::Edit& edit) override;
  void check(const boxplus::Settings& settings) const override;
  boxplus::viewer::Outcome run(const boxplus::Settings& settings,
                               boxplus::viewer::Listener& listener) override;
  boxplus::viewer::Outcome step(const boxplus::Settings& settings,
                                boxplus::viewer::Listener& listener) override;
  bool guess(const std::string& start, boxplus::viewer::Listener& listener) override;
  void keep_estimates() override;
  void restore() override;
  void drop_estimates() override;
  std::string diagnosis(std::uint64_t structure, const std::atomic<bool>& stop) const override;
  boxplus::viewer::Message pattern(const std::atomic<bool>& stop) const override;
  std::string formatted(const std::string& format) const override;

 private:
  struct Choice {
    std::string algorithm, kernel, start = "current";
    std::optional<double> kernel_width;
    bool only_closures = false;
    int iterations = 10;
  };

  std::vector<boxplus::Setting> settings() const;
  Choice choice_of(const boxplus::Settings& settings) const;
  boxplus::viewer::Outcome iterate(const Choice& choice, boxplus::viewer::Listener& listener);
  bool use_algorithm(const std::string& name);
  void set_kernels(const Choice& choice);
  void make_guess(const std::string& start);

  std::unique_ptr<SparseOptimizer> own_;
  SparseOptimizer* optimizer_;
  std::string name_;
  std::string algorithm_;  ///< the name of the algorithm that this subject has set
  bool has_kernels_ = false;
  /// The drawing of the current estimates, and the structure of the last update_structure().
  mutable std::unique_ptr<RecordedDrawing> drawing_;
  boxplus::viewer::Structure structure_;
};

/// Iterations as rows of the viewer's table.
class IterationRows {
 public:
  explicit IterationRows(SparseOptimizer& optimizer);
  boxplus::IterationRecord next(int iteration);

 private:
  SparseOptimizer& optimizer_;
  double chi2_;
  double begin_s_;
};

}  // namespace internal
}  // namespace g2o
