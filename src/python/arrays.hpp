// Between numpy and the library: results as views that keep what they look at, inputs as plain arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

namespace py = pybind11;

/// C-contiguous, converted where it is not.
template <class T>
using ArrayOf = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// Who keeps the memory of a view.
using Owner = std::shared_ptr<const void>;

/// A read-only view of other memory, which lives as long as the view. Strides in bytes.
template <class T>
py::array view(Owner owner, const T* first, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides) {
  const py::capsule base(new Owner(std::move(owner)), [](void* kept) { delete static_cast<Owner*>(kept); });
  py::array array(py::dtype::of<T>(), std::move(shape), std::move(strides), first, base);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// Of a member of each item: `first` is that of the first one, of `width` numbers; one number is no column.
template <class T, class Item>
py::array view_of_items(Owner owner, const std::vector<Item>& items, const T* first, py::ssize_t width = 1) {
  const auto rows = py::ssize_t(items.size());
  if (width == 1) return view<T>(std::move(owner), first, {rows}, {sizeof(Item)});
  return view<T>(std::move(owner), first, {rows, width}, {sizeof(Item), sizeof(T)});
}

/// Takes over a vector without a copy.
template <class T>
py::array taken(std::vector<T> values) {
  const auto kept = std::make_shared<const std::vector<T>>(std::move(values));
  return view<T>(kept, kept->data(), {py::ssize_t(kept->size())}, {sizeof(T)});
}

/// A small matrix, copied.
template <class Matrix>
py::array matrix(const Matrix& values) {
  py::array_t<double> array({py::ssize_t(values.rows()), py::ssize_t(values.cols())});
  for (Index i = 0; i < values.rows(); ++i)
    for (Index j = 0; j < values.cols(); ++j) array.mutable_at(i, j) = values(i, j);
  return array;
}

}  // namespace bondstatic
