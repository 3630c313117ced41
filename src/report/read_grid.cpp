#include "report/read_grid.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/error.hpp"

namespace bondstatic {

Grid::Grid(const std::vector<std::string>& files) {
  for (const std::string& file : files) files_.emplace_back(file);
  point_arrays_ = files_.at(0).arrays(Of::points);
  line_arrays_ = files_.at(0).arrays(Of::lines);
  for (const GridFile& file : files_)
    if (file.arrays(Of::points) != point_arrays_ || file.arrays(Of::lines) != line_arrays_)
      throw InputError({{{file.path()},
                         fmt::format("has other arrays than {}, of the same grid", path()),
                         "solve the case again: the files are of different runs"}});
}

Index Grid::count(Of of) const {
  Index count = 0;
  for (const GridFile& file : files_) count += file.count(of);
  return count;
}

bool Grid::has(Of of, const std::string& array) const {
  return std::any_of(arrays(of).begin(), arrays(of).end(),
                     [&](const GridArray& one) { return one.name == array; });
}

std::vector<double> Grid::numbers(Of of, const std::string& array) const {
  std::vector<double> numbers;
  for (const GridFile& file : files_) file.append(of, array, numbers);
  return numbers;
}

std::vector<Index> Grid::whole_numbers(Of of, const std::string& array) const {
  std::vector<Index> numbers;
  for (const GridFile& file : files_) file.append(of, array, numbers);
  return numbers;
}

std::vector<double> Grid::positions() const {
  std::vector<double> positions;
  for (const GridFile& file : files_) file.append_positions(positions);
  return positions;
}

std::vector<Index> Grid::ends() const {
  std::vector<Index> ends;
  Index points_before = 0;
  for (const GridFile& file : files_) {
    const std::size_t begin = ends.size();
    file.append_ends(ends);
    for (std::size_t i = begin; i < ends.size(); ++i) ends[i] += points_before;
    points_before += file.count(Of::points);
  }
  return ends;
}

std::vector<bool> Grid::copies() const {
  std::vector<bool> copies;
  for (const GridFile& file : files_) file.append_copies(copies);
  return copies;
}

}  // namespace bondstatic
