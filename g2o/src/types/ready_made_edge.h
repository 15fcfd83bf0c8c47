// SPDX-License-Identifier: BSD-3-Clause
// Defines EdgeFunctions. Only the sources of ready-made edges include this header. Such a source specializes
// EdgeModel<Edge>, which says how the edge differs from others, and then instantiates EdgeFunctions<Edge>.
//
// A model has as many of these members as the edge needs:
//   Native                the edge type of the engine
//   native(e)             makes a Native that needs more than the measurement
//   parameters(e)         the arguments of Native after the vertices, as a tuple. Required if the edge has
//                         parameters of the graph.
//   linearized(e)         changes the Jacobians that Native computed
//   error(e), linearize(e)  the error, and a function that sets the Jacobians, if there is no Native
//   kFields               the number of fields of the measurement in files, if it is not kSize
//   taken(e, native)      takes more than the measurement from a Native that was read from a file
//   from_file(in), to_file(e, out)  read and write the measurement, if neither a Native nor its type does
//   rest(e)               pointers to the optional numbers after Ω in files, as an array
//   measured(e)           the measurement that the estimates predict
//   first(e), second(e)   estimates of vertex 0 and of vertex 1 that agree with the measurement. With both,
//                         the edge can compute each from the other vertex. With only second(), it can compute
//                         vertex 1 from all others, and with only first(), vertex 0 from the measurement
//                         alone.
//   possible(e, from, to), guess(e, to)  other forms of initialEstimatePossible(), initialEstimate()
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "g2o/core/ready_made_edge.h"
#include "types/adapters.h"

namespace g2o {
namespace internal {

template <class Adapter>
concept HasData = requires {
  Adapter::kSize;
};

/// The estimate of vertex N.
template <int N, class Edge>
const auto& estimate(const Edge& e) {
  return e.template vertexXn<N>()->estimate();
}

/// The base of the model of an edge whose measurement is only a part of an estimate. initialEstimate() sets
/// the estimate, but initialEstimatePossible() does not offer this.
struct NoInitialEstimate {
  static bool possible(const OptimizableGraph::Edge&, const OptimizableGraph::VertexSet&,
                       const OptimizableGraph::Vertex*) {
    return false;
  }
};

/// The base of the model of an edge that computes each of the vertices 0 and 1 from the other one. Unlike for
/// other edges, `to` says which, because the other one may not be all that is necessary.
template <class Edge>
struct GuessedFromOther {
  static void guess(Edge& e, const OptimizableGraph::Vertex* to) {
    if (to == e.vertices()[1]) {
      e.template vertexXn<1>()->setEstimate(EdgeModel<Edge>::second(e));
    } else {
      e.template vertexXn<0>()->setEstimate(EdgeModel<Edge>::first(e));
    }
  }
};

/// The Native of the edge, for a model that has one.
template <class Edge, class Z>
auto native_edge(const Edge& e, const Z& z) {
  using Model = EdgeModel<Edge>;
  if constexpr (requires { Model::native(e); }) {
    return Model::native(e);
  } else {
    return typename Model::Native(z);
  }
}

/// Calls `call` with the positions of the vertices as constants, and then with the parameters. The attribute
/// inlines the functions of the engine, as if each edge were alone in its source.
template <class Edge, class Call>
[[gnu::flatten]] auto with_arguments(const Edge& e, Call&& call) {
  return [&]<int... N>(std::integer_sequence<int, N...>) {
    const auto with_parameters = [&](const auto&... parameters) {
      return call(std::integer_sequence<int, N...>(), parameters...);
    };
    if constexpr (requires { EdgeModel<Edge>::parameters(e); }) {
      return std::apply(with_parameters, EdgeModel<Edge>::parameters(e));
    } else {
      return with_parameters();
    }
  }
  (std::make_integer_sequence<int, static_cast<int>(Edge::_nr_of_vertices)>());
}

template <class Edge>
using AdapterOf = MeasurementAdapter<typename Edge::Measurement>;

template <class Edge>
constexpr int measurement_fields() {
  if constexpr (requires { EdgeModel<Edge>::kFields; }) {
    return EdgeModel<Edge>::kFields;
  } else {
    return AdapterOf<Edge>::kSize;
  }
}

template <class Edge>
void EdgeFunctions<Edge>::compute_error(Edge& e) {
  using Model = EdgeModel<Edge>;
  const auto error = [&e] {
    if constexpr (requires { Model::error(e); }) {
      return Model::error(e);
    } else {
      const auto native = native_edge(e, AdapterOf<Edge>::native(e._measurement, e));
      return with_arguments(
          e, [&]<int... N>(std::integer_sequence<int, N...>, const auto&... parameters) {
            return native.error(native_value(*e.template vertexXn<N>())..., parameters...);
          });
    }
  };
  if constexpr (Edge::Dimension == 1) {
    e._error[0] = error();
  } else {
    e._error = error();
  }
}

template <class Edge>
void EdgeFunctions<Edge>::linearize(Edge& e) {
  using Model = EdgeModel<Edge>;
  if constexpr (requires { Model::linearize(e); }) {
    Model::linearize(e);
  } else {
    const auto native = native_edge(e, AdapterOf<Edge>::native(e._measurement, e));
    with_arguments(
        e, [&]<int... N>(std::integer_sequence<int, N...>, const auto&... parameters) {
          adapters::linearize(native,
                              adapters::Argument{native_value(*e.template vertexXn<N>()),
                                                 std::get<N>(e._jacobianOplus).data()}...,
                              adapters::Argument{parameters, nullptr}...);
        });
    if constexpr (requires { Model::linearized(e); }) Model::linearized(e);
  }
}

template <class Edge>
bool EdgeFunctions<Edge>::read(Edge& e, std::istream& is) {
  using Model = EdgeModel<Edge>;
  using Adapter = AdapterOf<Edge>;
  if constexpr (requires { Model::parameters(e); }) {
    if (!e.readParamIds(is)) return false;
  }
  const int fields = measurement_fields<Edge>() + adapters::omega_fields(e._information);
  const bool good = adapters::read_fields(is, fields, [&e](boxplus::FieldReader& in) {
    if constexpr (requires { Model::from_file(in); }) {
      const typename Edge::Measurement z = Model::from_file(in);
      adapters::read_omega(in, e._information);
      e.setMeasurement(z);
    } else if constexpr (requires { typename Model::Native; }) {
      const auto native = boxplus::EdgeFields<typename Model::Native>::read(in);
      adapters::read_omega(in, e._information);
      e.setMeasurement(Adapter::to_g2o(native.measurement));
      if constexpr (requires { Adapter::remember(native.measurement, e._measurement, e); })
        Adapter::remember(native.measurement, e._measurement, e);
      if constexpr (requires { Model::taken(e, native); }) Model::taken(e, native);
    } else {
      const auto z = boxplus::FileFields<typename Adapter::Native>::read(in);
      adapters::read_omega(in, e._information);
      e.setMeasurement(Adapter::to_g2o(z));
    }
  });
  if constexpr (requires { Model::rest(e); }) {
    return good &&
           std::apply([&](auto*... number) { return adapters::read_rest(is, {number...}); }, Model::rest(e));
  } else {
    return good;
  }
}

template <class Edge>
bool EdgeFunctions<Edge>::write(const Edge& e, std::ostream& os) {
  using Model = EdgeModel<Edge>;
  using Adapter = AdapterOf<Edge>;
  if constexpr (requires { Model::parameters(e); }) {
    if (!e.writeParamIds(os)) return false;
  }
  const bool good = adapters::write_fields(os, [&e](boxplus::FieldWriter& out) {
    if constexpr (requires { Model::to_file(e, out); }) {
      Model::to_file(e, out);
    } else if constexpr (requires { typename Model::Native; }) {
      const auto native = native_edge(e, Adapter::native(e._measurement, e));
      boxplus::EdgeFields<typename Model::Native>::write(native, out);
    } else {
      boxplus::FileFields<typename Adapter::Native>::write(Adapter::native(e._measurement, e), out);
    }
    adapters::write_omega(e._information, out);
  });
  if constexpr (requires { Model::rest(e); }) {
    return good && std::apply([&](auto*... number) { return adapters::write_rest(os, {*number...}); },
                              Model::rest(e));
  } else {
    return good;
  }
}

template <class Edge>
int EdgeFunctions<Edge>::measurement_size() {
  if constexpr (HasData<AdapterOf<Edge>>) {
    return AdapterOf<Edge>::kSize;
  } else {
    return -1;
  }
}

template <class Edge>
bool EdgeFunctions<Edge>::set_data(Edge& e, const double* d) {
  if constexpr (HasData<AdapterOf<Edge>>) e.setMeasurement(AdapterOf<Edge>::from_data(d));
  return HasData<AdapterOf<Edge>>;
}

template <class Edge>
bool EdgeFunctions<Edge>::get_data(const Edge& e, double* d) {
  if constexpr (HasData<AdapterOf<Edge>>) {
    const auto& v = AdapterOf<Edge>::to_data(e._measurement, e);
    std::copy_n(v.data(), AdapterOf<Edge>::kSize, d);
  }
  return HasData<AdapterOf<Edge>>;
}

template <class Edge>
bool EdgeFunctions<Edge>::measure(Edge& e) {
  constexpr bool kCan = requires {
    EdgeModel<Edge>::measured(e);
  };
  if constexpr (kCan) e.setMeasurement(EdgeModel<Edge>::measured(e));
  return kCan;
}

template <class Edge>
double EdgeFunctions<Edge>::cost_of_guess(const Edge& e, const Vertices& from,
                                          const OptimizableGraph::Vertex* to) {
  using Model = EdgeModel<Edge>;
  bool possible = false;
  if constexpr (requires { Model::possible(e, from, to); }) {
    possible = Model::possible(e, from, to);
  } else if constexpr (requires { Model::first(e); }) {
    possible = true;
  } else if constexpr (requires { Model::second(e); }) {
    possible = to == e._vertices[1];
    for (std::size_t i = 0; i < e._vertices.size(); ++i) {
      if (i != 1 && from.count(e._vertices[i]) == 0) possible = false;
    }
  }
  return possible ? 1 : -1;
}

template <class Edge>
void EdgeFunctions<Edge>::guess(Edge& e, const Vertices& from, const OptimizableGraph::Vertex* to) {
  using Model = EdgeModel<Edge>;
  constexpr bool kFirst = requires {
    Model::first(e);
  }
  , kSecond = requires {
    Model::second(e);
  };
  if constexpr (requires { Model::guess(e, to); }) {
    Model::guess(e, to);
  } else if constexpr (kFirst && kSecond) {
    if (from.count(e._vertices[0]) > 0) {
      e.template vertexXn<1>()->setEstimate(Model::second(e));
    } else {
      e.template vertexXn<0>()->setEstimate(Model::first(e));
    }
  } else if constexpr (kSecond) {
    e.template vertexXn<1>()->setEstimate(Model::second(e));
  } else if constexpr (kFirst) {
    e.template vertexXn<0>()->setEstimate(Model::first(e));
  }
}

}  // namespace internal
}  // namespace g2o
