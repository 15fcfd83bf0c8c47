// SPDX-License-Identifier: BSD-3-Clause
#include "convert.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boxplus::python {
namespace {

std::string shape_of(const py::array& array) {
  return py::str(array.attr("shape"));
}

/// The message of all errors of this file.
std::string message(std::string_view name, std::string_view expected, const std::string& came) {
  return std::string(name) + ": expected " + std::string(expected) + ", got " + came;
}

/// "[3, 1]": the place of a value in an array whose values are numbered row by row.
std::string place(const py::array& array, py::ssize_t index) {
  const py::object indices = py::module_::import("numpy").attr("unravel_index")(index, array.attr("shape"));
  return py::str(py::list(indices));
}

/// The first masked array (numpy.ma) with masked numbers: the value, or an item of its lists and tuples.
/// NumPy would forget its mask. Null if there is none.
py::object find_masked(py::handle value, py::ssize_t dims) {
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    if (dims == 0) return {};
    for (const py::handle item : py::reinterpret_borrow<py::sequence>(value)) {
      if (py::object found = find_masked(item, dims - 1)) return found;
    }
    return {};
  }
  const bool is_plain = Py_TYPE(value.ptr()) == py::detail::npy_api::get().PyArray_Type_;
  if (is_plain || !py::isinstance<py::array>(value)) return {};
  const py::module_ ma = py::module_::import("numpy.ma");
  if (!py::isinstance(value, ma.attr("MaskedArray")) || !ma.attr("is_masked")(value).cast<bool>()) return {};
  return py::reinterpret_borrow<py::object>(value);
}

void require_unmasked(py::handle value, py::ssize_t dims, std::string_view name) {
  const py::object masked = find_masked(value, dims);
  if (masked)
    py::module_::import("boxplus._masks").attr("require_unmasked")(py::make_tuple(masked), std::string(name));
}

/// A NumPy array of any type.
py::array read_any(py::handle value, std::string_view name, std::string_view expected) {
  py::array array = py::array::ensure(value);
  if (!array) throw_type_error(name, expected, value);
  require_unmasked(value, array.ndim(), name);
  return array;
}

/// A one-dimensional array of integers. An empty one may have another type.
py::array read_integers(py::handle value, std::string_view name) {
  const std::string expected = "an array of integers of shape (n,)";
  py::array array = read_any(value, name, expected);
  if (array.ndim() != 1) throw_value_error(name, expected, array);
  const char kind = array.dtype().kind();
  if (array.size() > 0 && kind != 'i' && kind != 'u') throw_type_error(name, expected, array);
  return array;
}

void require_finite(const Numbers& numbers, std::string_view name) {
  const double* const begin = numbers.data();
  const double* const end = begin + numbers.size();
  const double* const wrong = std::find_if(begin, end, [](double x) { return !std::isfinite(x); });
  if (wrong == end) return;
  const std::string at = numbers.ndim() == 0 ? "" : " at " + place(numbers, wrong - begin);
  throw py::value_error(message(name, "finite numbers", std::string(py::str(py::float_(*wrong))) + at));
}

/// "shape (n, 3) with the columns x y theta"
std::string rows_text(int columns, std::string_view layout) {
  std::string text = "an array of shape (n, " + std::to_string(columns) + ")";
  if (columns == 1) text += " or (n,)";
  return text + " with the columns " + std::string(layout);
}

}  // namespace

std::string described(py::handle value) {
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    return "a " + std::string(py::str(array.dtype())) + " array of shape " + shape_of(array);
  }
  std::string text = py::repr(value);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text + " (" + std::string(py::str(py::type::handle_of(value).attr("__name__"))) + ")";
}

void throw_type_error(std::string_view name, std::string_view expected, py::handle came) {
  throw py::type_error(message(name, expected, described(came)));
}
void throw_value_error(std::string_view name, std::string_view expected, py::handle came) {
  throw py::value_error(message(name, expected, described(came)));
}

Numbers read_numbers(py::handle value, std::string_view name) {
  const py::array array = read_any(value, name, "an array of real numbers");
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') throw_type_error(name, "an array of real numbers", value);
  auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!numbers) throw py::error_already_set();
  Numbers result = py::reinterpret_borrow<Numbers>(numbers);
  require_finite(result, name);
  return result;
}

std::vector<double> read_vector(py::handle value, int size, std::string_view name, std::string_view layout) {
  const Numbers numbers = read_numbers(value, name);
  if (numbers.ndim() != 1 || numbers.size() != size) {
    throw_value_error(name, "an array of shape (" + std::to_string(size) + ",): " + std::string(layout),
                      numbers);
  }
  return {numbers.data(), numbers.data() + size};
}

Numbers read_rows(py::handle value, int columns, std::string_view name, std::string_view layout) {
  Numbers numbers = read_numbers(value, name);
  const bool is_list = numbers.ndim() == 1 && (columns == 1 || numbers.size() == 0);
  if (!is_list && (numbers.ndim() != 2 || numbers.shape(1) != columns))
    throw_value_error(name, rows_text(columns, layout), numbers);
  return numbers;
}

double read_number(py::handle value, std::string_view name) {
  const Numbers numbers = read_numbers(value, name);
  if (numbers.size() != 1) throw_value_error(name, "one number", numbers);
  return *numbers.data();
}

bool is_integer(py::handle value) {
  return PyIndex_Check(value.ptr()) != 0 && !py::isinstance<py::bool_>(value) &&
         !py::isinstance<py::array>(value);
}

std::int64_t read_integer(py::handle value, std::string_view name) {
  if (!is_integer(value)) throw_type_error(name, "an int", value);
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!number) throw py::error_already_set();
  int overflow = 0;
  const long long result = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0) throw_value_error(name, "an int of at most 64 bits", value);
  return result;
}

int read_int(py::handle value, std::string_view name) {
  const std::int64_t number = read_integer(value, name);
  if (!std::in_range<int>(number)) throw_value_error(name, "an int of 32 bits", value);
  return static_cast<int>(number);
}

std::vector<int> read_ints(py::handle value, std::string_view name) {
  std::vector<int> result;
  for (const py::handle item : read_integers(value, name)) result.push_back(read_int(item, name));
  return result;
}

std::vector<Id> read_ids(py::handle value, std::string_view name) {
  const py::array array = read_integers(value, name);
  if (array.size() == 0) return {};
  const auto ids = py::array_t<Id, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!ids) throw py::error_already_set();
  const Id* const end = ids.data() + ids.size();
  const Id* const negative = std::find_if(ids.data(), end, [](Id id) { return id < 0; });
  if (negative != end) {
    const py::object came = array[py::int_(negative - ids.data())];
    throw py::value_error(message(name, "ids from 0 to 2**63 - 1",
                                  std::string(py::str(came)) + " at " + place(array, negative - ids.data())));
  }
  return {ids.data(), end};
}

Informations::Informations(py::handle value, int rows, std::string_view name)
    : numbers_(read_numbers(value, name)), rows_(rows), name_(name) {
  const py::ssize_t dims = numbers_.ndim();
  is_matrix_ = dims >= 2;
  is_shared_ = dims == 0 || dims == 2;
  const bool fits = is_matrix_
                        ? dims <= 3 && numbers_.shape(dims - 1) == rows && numbers_.shape(dims - 2) == rows
                        : dims <= 1;
  if (!fits) {
    const std::string n = std::to_string(rows);
    throw_value_error(
        name, "a number, or an array of shape (" + n + ", " + n + "), (n,) or (n, " + n + ", " + n + ")",
        numbers_);
  }
}

void Informations::require_count(std::size_t edges) const {
  if (!is_shared_ && static_cast<std::size_t>(numbers_.shape(0)) != edges)
    throw_value_error(name_, "one information for all edges or one for each of " + std::to_string(edges),
                      numbers_);
}

Information Informations::operator[](std::size_t edge) const {
  const std::size_t step = is_shared_ ? 0 : edge;
  if (!is_matrix_) return Information(numbers_.data()[step]);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const double* const values =
      numbers_.data() + step * static_cast<std::size_t>(rows_) * static_cast<std::size_t>(rows_);
  return Information(Eigen::Map<const RowMajor>(values, rows_, rows_));
}

Numbers to_array(std::span<const double> values) {
  return Numbers(static_cast<py::ssize_t>(values.size()), values.data());
}
Numbers to_array(const Eigen::MatrixXd& matrix) {
  Numbers array({matrix.rows(), matrix.cols()});
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) array.mutable_at(i, j) = matrix(i, j);
  }
  return array;
}
py::array_t<Id> to_array(std::span<const Id> ids) {
  return py::array_t<Id>(static_cast<py::ssize_t>(ids.size()), ids.data());
}

}  // namespace boxplus::python
