// A named column of numbers, as the writers of tables and of VTK files take it. Numbers are asked for one at
// a time, so that the columns of a million bonds need no memory of their own.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

struct Column {
  /// Number i = row * components + component; may be called by several threads at once.
  template <class T>
  using Numbers = std::function<T(Index)>;

  std::string name;
  std::variant<Numbers<Index>, Numbers<double>> at;
  Index count;  ///< of numbers
  int components;

  Column(std::string named, Index numbers, std::variant<Numbers<Index>, Numbers<double>> number_at,
         int per_row = 1)
      : name(std::move(named)), at(std::move(number_at)), count(numbers), components(per_row) {}

  /// Keeps the numbers.
  template <class T>
  Column(std::string named, std::vector<T> numbers, int per_row = 1)
      : name(std::move(named)), count(Index(numbers.size())), components(per_row) {
    at = Numbers<T>([kept = std::make_shared<const std::vector<T>>(std::move(numbers))](Index i) {
      return (*kept)[std::size_t(i)];
    });
  }

  Index rows() const { return count / components; }
};

/// Rows of another column in the order given; both must outlive this one.
inline Column rows_of(const Column& column, std::span<const Index> rows) {
  return std::visit(
      [&]<class T>(const Column::Numbers<T>& at) {
        const Index width = column.components;
        const Column::Numbers<T> of_row = [&at, rows, width](Index i) {
          return at(rows[std::size_t(i / width)] * width + i % width);
        };
        return Column(column.name, Index(rows.size()) * width, of_row, column.components);
      },
      column.at);
}

}  // namespace bondstatic
