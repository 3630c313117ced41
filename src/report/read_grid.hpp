// The grid of a state, in one file or in a piece a rank, as if it were one.
#pragma once

#include <string>
#include <vector>

#include "report/grid_file.hpp"

namespace bondstatic {

/// Arrays are decoded when they are asked for. Every function throws Error (invalid_input) that names the
/// file.
class Grid {
 public:
  using Of = GridFile::Of;

  explicit Grid(const std::vector<std::string>& files);

  Index count(Of of) const;
  /// Without vtkGhostType.
  const std::vector<GridArray>& arrays(Of of) const {
    return of == Of::points ? point_arrays_ : line_arrays_;
  }
  bool has(Of of, const std::string& array) const;

  std::vector<double> numbers(Of of, const std::string& array) const;  ///< row by row
  std::vector<Index> whole_numbers(Of of, const std::string& array) const;
  std::vector<double> positions() const;  ///< x, y, z
  std::vector<Index> ends() const;        ///< two points a line
  /// Points that stand for a particle of another piece, or for its image across a periodic face.
  std::vector<bool> copies() const;

  const std::string& path() const { return files_.front().path(); }

 private:
  std::vector<GridFile> files_;
  std::vector<GridArray> point_arrays_, line_arrays_;
};

}  // namespace bondstatic
