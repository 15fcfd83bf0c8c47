// SPDX-License-Identifier: BSD-3-Clause
// Adapters from the ready-made types of the g2o API to the types of the engine (boxplus). They convert
// errors, Jacobians, and fields of files.
#pragma once

#include <array>
#include <initializer_list>
#include <istream>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boxplus/graph/differentiate.h"
#include "boxplus/io/file_fields.h"
#include "boxplus/io/registry.h"
#include "core/line_stream.h"
#include "g2o/core/ready_made_edge.h"

namespace g2o {
namespace adapters {

/// The message of an InputError, without the position in the file.
inline std::string without_place(const std::string& file, const boxplus::InputError& error) {
  const std::string place =
      file + ":" + std::to_string(error.line()) + ":" + std::to_string(error.column()) + ": ";
  const std::string text = error.what();
  return text.compare(0, place.size(), place) == 0 ? text.substr(place.size()) : text;
}

/// Passes the next `count` fields of a stream to `read`. Returns false if there are too few fields. If the
/// fields are invalid, reports an error message and returns false.
template <class Read>
bool read_fields(std::istream& is, int count, Read&& read) {
  std::string text, word;
  for (int i = 0; i < count; ++i) {
    if (!(is >> word)) return false;
    text += word;
    text += ' ';
  }
  try {
    boxplus::FieldReader in("", 1, text);
    read(in);
    return true;
  } catch (const boxplus::InputError& error) {
    internal::complain(is, without_place("", error));
  } catch (const boxplus::Error& error) {
    internal::complain(is, error.what());
  }
  return false;
}

/// Calls `write` with a FieldWriter, and writes the resulting text to the stream.
template <class Write>
bool write_fields(std::ostream& os, Write&& write) {
  std::string text;
  boxplus::FieldWriter out(text);
  write(out);
  os << text;
  return os.good();
}

template <class T>
bool read_value(std::istream& is, int count, T& value) {
  return read_fields(is, count, [&](boxplus::FieldReader& in) { value = boxplus::FileFields<T>::read(in); });
}

template <class T>
bool write_value(std::ostream& os, const T& value) {
  return write_fields(os, [&](boxplus::FieldWriter& out) { boxplus::FileFields<T>::write(value, out); });
}

/// Whether the next `count` fields are zero.
inline bool are_zeros(boxplus::FieldReader in, int count) {
  for (int i = 0; i < count; ++i) {
    if (in.number("an entry of the information matrix") != 0) return false;
  }
  return true;
}

/// Reads Ω. Unlike the engine, this function accepts an Ω of zeros, which gives the edge no weight.
template <class Omega>
void read_omega(boxplus::FieldReader& in, Omega& information) {
  const auto rows = static_cast<int>(information.rows());
  if (are_zeros(in, rows * (rows + 1) / 2)) {
    information.setZero();
    return;
  }
  const boxplus::Information omega = boxplus::read_information(in, rows);
  information = boxplus::detail::InformationView{omega.kind(), rows, omega.values().data()}.matrix();
}
template <class Omega>
int omega_fields(const Omega& information) {
  return static_cast<int>(information.rows() * (information.rows() + 1) / 2);
}
template <class Omega>
void write_omega(const Omega& information, boxplus::FieldWriter& out) {
  for (Eigen::Index i = 0; i < information.rows(); ++i) {
    for (Eigen::Index j = i; j < information.cols(); ++j) out.number(information(i, j));
  }
}

/// Reads the measurement of an edge of the engine, and then Ω. The measurement has `count` fields.
template <class E, class Omega, class Take>
bool read_edge(std::istream& is, int count, Omega& information, Take&& take) {
  return read_fields(is, count + omega_fields(information), [&](boxplus::FieldReader& in) {
    const E edge = boxplus::EdgeFields<E>::read(in);
    read_omega(in, information);
    take(edge.measurement);
  });
}

template <class E, class Omega>
bool write_edge(std::ostream& os, const E& edge, const Omega& information) {
  return write_fields(os, [&](boxplus::FieldWriter& out) {
    boxplus::EdgeFields<E>::write(edge, out);
    write_omega(information, out);
  });
}

/// Does the same as read_edge() for an edge type that the engine does not have. In files, the measurement has
/// the same fields as a value of type T.
template <class T, class Omega, class Take>
bool read_measurement(std::istream& is, int count, Omega& information, Take&& take) {
  return read_fields(is, count + omega_fields(information), [&](boxplus::FieldReader& in) {
    const T measurement = boxplus::FileFields<T>::read(in);
    read_omega(in, information);
    take(measurement);
  });
}

template <class T, class Omega>
bool write_measurement(std::ostream& os, const T& measurement, const Omega& information) {
  return write_fields(os, [&](boxplus::FieldWriter& out) {
    boxplus::FileFields<T>::write(measurement, out);
    write_omega(information, out);
  });
}

/// Reads optional values at the end of a line. If the line has none, the values stay unchanged. Returns false
/// if the line has only some of the values, or other fields.
inline bool read_rest(std::istream& is, std::initializer_list<double*> numbers) {
  const std::istream::int_type next = is.eof() ? std::istream::traits_type::eof() : (is >> std::ws).peek();
  if (next == std::istream::traits_type::eof()) {
    is.clear(std::ios::eofbit);
    return true;
  }
  std::vector<double> read;
  const bool ok = read_fields(is, static_cast<int>(numbers.size()), [&](boxplus::FieldReader& in) {
    for (std::size_t i = 0; i < numbers.size(); ++i) read.push_back(in.number("a number"));
  });
  for (std::size_t i = 0; ok && i < read.size(); ++i) *numbers.begin()[i] = read[i];
  return ok;
}

inline bool write_rest(std::ostream& os, std::initializer_list<double> numbers) {
  return write_fields(os << ' ', [&](boxplus::FieldWriter& out) {
    for (const double number : numbers) out.number(number);
  });
}

/// An argument of an edge of the engine, and the memory for the Jacobian with respect to this argument. The
/// memory is nullptr for parameters.
template <class V>
struct Argument {
  V value;
  double* jacobian = nullptr;
};
template <class V>
Argument(V, double*) -> Argument<V>;

/// Converts a Jacobian from the tangent space of the engine to the tangent space of g2o. The spaces differ
/// only for poses in the plane, because g2o adds their translations in the world frame: δ_body = R(θ)ᵀ
/// δ_world.
template <int Rows>
void to_g2o_tangent(const boxplus::SE2& x, double* jacobian) {
  Eigen::Map<Eigen::Matrix<double, Rows, 2>> J(jacobian);
  J = (J * x.rotation().transpose()).eval();
}
template <int Rows, class V>
void to_g2o_tangent(const V&, double*) {}

/// Computes the Jacobians of an edge of the engine: with jacobians() if the edge has this function, otherwise
/// with dual numbers.
template <class E, class... V>
void linearize(const E& edge, const Argument<V>&... arguments) {
  constexpr int kRows = boxplus::detail::kRows<boxplus::detail::Result<E, V...>>;
  constexpr int kCols = boxplus::detail::kCols<V...>;
  std::array<double, static_cast<std::size_t>(kRows * kCols)> buffer;
  double* block = buffer.data();
  const auto next = [&](int dim) { return std::exchange(block, block + kRows * dim); };
  if constexpr (boxplus::detail::kAnalytic<E, V...>) {
    std::tuple<boxplus::detail::JacobianBlock<V, kRows>...> blocks{
        boxplus::detail::JacobianBlock<V, kRows>(next(boxplus::Manifold<V>::kDim))...};
    std::apply([&](auto&... J) { edge.jacobians(arguments.value..., J...); }, blocks);
  } else {
    std::array<double, static_cast<std::size_t>(kRows)> error;
    boxplus::detail::automatic_jacobian<V...>(edge, error.data(), buffer.data(), kRows, kCols,
                                              arguments.value...);
  }
  block = buffer.data();
  const auto deliver = [&](const auto& argument, int dim) {
    double* from = next(dim);
    if (argument.jacobian == nullptr) return;
    to_g2o_tangent<kRows>(argument.value, from);
    std::copy_n(from, kRows * dim, argument.jacobian);
  };
  (deliver(arguments, boxplus::Manifold<V>::kDim), ...);
}

}  // namespace adapters

namespace internal {

/// Converts measurements to the type of the engine and back, and to kSize numbers and back. The primary
/// template is for vectors.
template <class E>
struct MeasurementAdapter {
  static constexpr int kSize = E::RowsAtCompileTime;
  using Native = boxplus::Vector<double, kSize>;
  static Native native(const E& z, const KeptMeasurement<E>&) { return z; }
  static E to_g2o(const Native& z) { return z; }
  static E from_data(const double* d) { return Eigen::Map<const Eigen::Matrix<double, kSize, 1>>(d); }
  static const E& to_data(const E& z, const KeptMeasurement<E>&) { return z; }
};
template <>
struct MeasurementAdapter<double> {
  static constexpr int kSize = 1;
  using Native = double;
  static double native(double z, const KeptMeasurement<double>&) { return z; }
  static double to_g2o(double z) { return z; }
  static double from_data(const double* d) { return *d; }
  static std::array<double, 1> to_data(double z, const KeptMeasurement<double>&) { return {z}; }
};

}  // namespace internal
}  // namespace g2o
