// VTK's XML format for unstructured grids (.vtu), one piece: points and lines between them, with arrays of raw
// bytes appended and 64-bit headers; and the file that makes one grid of several pieces (.pvtu). ParaView, VTK
// and PyVista read both, meshio the first. The format:
// https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/column.hpp"
#include "io/output_file.hpp"

namespace bondstatic {

struct LineGrid {
  std::span<const double> points;  ///< x, y, z of each point, one after the other
  std::span<const Index> lines;    ///< two point numbers a line
  std::span<const Column> point_data;
  std::span<const Column> line_data;
  /// Of a piece of a larger grid: points from this one on are copies of other pieces' points. The point data
  /// then has vtkGhostType, which marks them.
  std::optional<Index> first_copy = {};
};

void write_vtu(OutputFile& file, const LineGrid& grid);

/// `pieces` are the paths of the .vtu files as seen from this one; all have these columns and vtkGhostType.
void write_pvtu(OutputFile& file, std::span<const Column> point_data, std::span<const Column> line_data,
                const std::vector<std::string>& pieces);

}  // namespace bondstatic
