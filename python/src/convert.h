// SPDX-License-Identifier: BSD-3-Clause
// Converts Python objects to numbers and arrays, and back. Every function that reads takes the name of the
// argument, and throws a TypeError or a ValueError that names the argument, what was expected and what came.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/graph/handle.h"
#include "boxplus/graph/information.h"

namespace boxplus::python {

namespace py = pybind11;

/// Numbers row by row, one after the other.
using Numbers = py::array_t<double, py::array::c_style>;

/// A row of an array, for messages: "estimates[3]".
struct RowName {
  std::string_view array;
  std::size_t row;
  std::string text() const { return std::string(array) + "[" + std::to_string(row) + "]"; }
};

/// "a float64 array of shape (3, 2)", "SE2(1, 2, 3)", "'text' (a str)"
std::string described(py::handle value);
[[noreturn]] void throw_type_error(std::string_view name, std::string_view expected, py::handle came);
[[noreturn]] void throw_value_error(std::string_view name, std::string_view expected, py::handle came);

/// Finite numbers of any shape: anything that NumPy turns into an array of real numbers.
Numbers read_numbers(py::handle value, std::string_view name);
/// `size` finite numbers. `layout` explains them in errors: "x y theta".
std::vector<double> read_vector(py::handle value, int size, std::string_view name, std::string_view layout);
/// An array of shape (n, columns) or, if there is one column, (n,).
Numbers read_rows(py::handle value, int columns, std::string_view name, std::string_view layout);
double read_number(py::handle value, std::string_view name);
/// An int or a NumPy integer, but no bool.
bool is_integer(py::handle value);
std::int64_t read_integer(py::handle value, std::string_view name);
int read_int(py::handle value, std::string_view name);
std::vector<int> read_ints(py::handle value, std::string_view name);
/// A one-dimensional array of integers that are not negative.
std::vector<Id> read_ids(py::handle value, std::string_view name);

/// The Ω of one edge or of many edges whose errors have `rows` rows: a number or a symmetric matrix for all
/// edges; an array of numbers (n,) or of matrices (n, rows, rows) for one edge each.
class Informations {
 public:
  Informations(py::handle value, int rows, std::string_view name);
  /// Throws a ValueError unless there is one Ω for all edges or one for each of `edges` edges.
  void require_count(std::size_t edges) const;
  Information operator[](std::size_t edge) const;

 private:
  Numbers numbers_;
  int rows_;
  std::string name_;
  bool is_matrix_, is_shared_;
};

Numbers to_array(std::span<const double> values);
Numbers to_array(const Eigen::MatrixXd& matrix);
py::array_t<Id> to_array(std::span<const Id> ids);

}  // namespace boxplus::python
