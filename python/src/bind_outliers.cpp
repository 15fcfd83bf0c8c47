// SPDX-License-Identifier: BSD-3-Clause
// find_outliers(): false loop closures.
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bind.h"
#include "boxplus/optimize/outliers.h"
#include "enumerators.h"
#include "members.h"
#include "observer.h"
#include "options_object.h"

namespace boxplus::python {
namespace {

constexpr std::tuple kVerdict{Member{"edge", &EdgeVerdict::edge},
                              Member{"from_", &EdgeVerdict::from},
                              Member{"to", &EdgeVerdict::to},
                              Member{"verdict", &EdgeVerdict::verdict},
                              Member{"weight", &EdgeVerdict::weight},
                              Member{"chi2", &EdgeVerdict::chi2},
                              Member{"supported", &EdgeVerdict::supported}};
constexpr std::tuple kOutlierReport{
    Member{"suspects", &OutlierReport::suspects}, Member{"report", &OutlierReport::report},
    Member{"verdicts", &OutlierReport::verdicts}, Member{"noise_scale", &OutlierReport::noise_scale},
    Member{"note", &OutlierReport::note}};

/// A search in a thread of its own. The calling thread, which may be the only one that can handle signals,
/// looks for them meanwhile. It also calls the callback.
class Search {
 public:
  Search(GraphObject::Run& run, const OptionsObject& object)
      : observer_(run, object.callback), user_stop_(object.stop), stop_(is_stopped_by_user()) {}

  OutlierReport find(Graph& graph, OutlierOptions options) {
    options.options.stop = &stop_;
    if (observer_.has_callback())
      options.options.callback = [this](const IterationRecord& record) { return ask(record); };
    std::future<OutlierReport> result = std::async(std::launch::async, [&] {
      const Notifier at_end(*this);
      return find_outliers(graph, options);
    });
    watch();
    return result.get();
  }
  void rethrow() { observer_.rethrow(); }

 private:
  /// Tells the calling thread that the search is over, also if it throws.
  class Notifier {
   public:
    explicit Notifier(Search& search) : search_(&search) {}
    ~Notifier() {
      const std::scoped_lock lock(search_->mutex_);
      search_->is_over_ = true;
      search_->changed_.notify_all();
    }
    Notifier(const Notifier&) = delete;
    Notifier& operator=(const Notifier&) = delete;

   private:
    Search* search_;
  };

  bool is_stopped_by_user() const { return user_stop_ && user_stop_->is_set; }

  /// Called by the search: the answer of the callback.
  bool ask(const IterationRecord& record) {
    std::unique_lock lock(mutex_);
    record_ = &record;
    changed_.notify_all();
    changed_.wait(lock, [this] { return record_ == nullptr; });
    return answer_;
  }
  /// Called by the calling thread: returns at the end of the search.
  void watch() {
    constexpr std::chrono::milliseconds kPeriod{20};
    std::unique_lock lock(mutex_);
    while (!is_over_) {
      changed_.wait_for(lock, kPeriod, [this] { return is_over_ || record_ != nullptr; });
      const IterationRecord* const record = record_;
      lock.unlock();
      bool go_on = !observer_.has_raised();
      if (go_on) go_on = record != nullptr ? observer_(*record) : observer_.check_signals();
      if (observer_.has_raised() || is_stopped_by_user()) stop_ = true;
      lock.lock();
      if (record == nullptr) continue;
      answer_ = go_on;
      record_ = nullptr;
      changed_.notify_all();
    }
  }

  Observer observer_;
  std::shared_ptr<StopFlag> user_stop_;
  std::atomic<bool> stop_;
  std::mutex mutex_;  // of the members below
  std::condition_variable changed_;
  const IterationRecord* record_ = nullptr;  // for which the search waits for an answer
  bool answer_ = true;
  bool is_over_ = false;
};

int read_window(py::handle value) {
  const std::int64_t window = read_integer(value, "window");
  if (!std::in_range<int>(window)) throw_value_error("window", "an int of 32 bits", value);
  return static_cast<int>(window);
}

OutlierReport find(GraphObject& graph, py::handle options, py::handle suspects, py::handle false_alarm,
                   py::handle evidence, py::handle window, const py::kwargs& changes) {
  const OptionsObject object = options_with(options, changes);
  const OutlierOptions native{.options = object.options,
                              .suspects = read_enumerator<Suspects>(suspects, "suspects"),
                              .false_alarm = read_number(false_alarm, "false_alarm"),
                              .evidence = read_number(evidence, "evidence"),
                              .window = read_window(window)};
  GraphObject::Run run(graph);
  Search search(run, object);
  OutlierReport report;
  {
    const py::gil_scoped_release release;
    report = search.find(run.graph(), native);
  }
  search.rethrow();
  return report;
}

/// An array of a member of each verdict.
template <class M>
py::array_t<M> column(const OutlierReport& report, M EdgeVerdict::*member) {
  py::array_t<M> array(static_cast<py::ssize_t>(report.verdicts.size()));
  M* out = array.mutable_data();
  for (const EdgeVerdict& verdict : report.verdicts) *out++ = verdict.*member;
  return array;
}

py::dict arrays(const OutlierReport& self) {
  py::list verdicts;
  for (const EdgeVerdict& verdict : self.verdicts) verdicts.append(std::string(to_string(verdict.verdict)));
  py::dict result;
  result["from"] = column(self, &EdgeVerdict::from);
  result["to"] = column(self, &EdgeVerdict::to);
  result["verdict"] = py::module_::import("numpy").attr("array")(verdicts, py::arg("dtype") = "U9");
  result["weight"] = column(self, &EdgeVerdict::weight);
  result["chi2"] = column(self, &EdgeVerdict::chi2);
  result["supported"] = column(self, &EdgeVerdict::supported);
  return result;
}

std::string text(const OutlierReport& self) {
  std::string text;
  for (const Enumerator<Verdict>& verdict : Enumerators<Verdict>::kAll)
    text += text_of(verdict.name) + "=" + std::to_string(self.count(verdict.value)) + ", ";
  return "OutlierReport(" + text + "noise_scale=" + std::string(py::repr(py::float_(self.noise_scale))) +
         ", note=" + std::string(py::repr(py::str(self.note))) + ")";
}

Verdict read_verdict(py::handle verdict) {
  return read_enumerator<Verdict>(verdict, "verdict");
}

}  // namespace

void bind_outliers(py::module_& module) {
  bind_enum<Suspects>(module);
  bind_enum<Verdict>(module);
  bind_struct<EdgeVerdict>(module, "EdgeVerdict", kVerdict);
  py::class_<OutlierReport> type(module, "OutlierReport",
                                 "The verdicts, one for each closure, and the report of the final run.");
  bind_members(type, kOutlierReport);
  type.def(
          "count",
          [](const OutlierReport& self, py::handle verdict) { return self.count(read_verdict(verdict)); },
          py::arg("verdict"), "The number of closures with a verdict, such as \"outlier\".")
      .def(
          "edges",
          [](const OutlierReport& self, py::handle verdict) { return self.edges(read_verdict(verdict)); },
          py::arg("verdict"), "The closures with a verdict, such as \"outlier\".")
      .def("arrays", &arrays,
           "The verdicts as a dict of arrays with one entry per closure: the ids \"from\" and \"to\", "
           "\"verdict\" (the text \"inlier\", \"outlier\" or \"undecided\"), \"weight\", \"chi2\" and "
           "\"supported\".")
      .def("__repr__", &text);

  const OutlierOptions defaults;
  module.def(
      "find_outliers", &find, py::arg("graph").none(false), py::arg("options") = py::none(), py::kw_only(),
      py::arg("suspects") = text_of(Enumerators<Suspects>::kAll[0].name),
      py::arg("false_alarm") = defaults.false_alarm, py::arg("evidence") = defaults.evidence,
      py::arg("window") = defaults.window,
      "find_outliers(graph, suspects=\"all\"): optimizes a graph without its false edges. The suspects are "
      "\"loop-closures\" or \"all\". boxplus/optimize/outliers.h explains the method, false_alarm, evidence "
      "and window; the other "
      "options are those of optimize(). Other threads of Python run meanwhile. Ctrl-C "
      "(KeyboardInterrupt) stops the search.");
  module.def(
      "to_string", [](Verdict verdict) { return std::string(to_string(verdict)); }, py::arg("value"));
}

}  // namespace boxplus::python
