// A named column of numbers, as the writers of tables and of VTK files take it.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

struct Column {
  std::string name;
  std::variant<std::vector<Index>, std::vector<double>> values;
  int components = 1;  ///< values of one row lie together

  Index rows() const {
    return std::visit([&](const auto& v) { return Index(v.size()) / components; }, values);
  }
};

}  // namespace bondstatic
