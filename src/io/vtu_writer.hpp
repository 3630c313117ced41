// VTK's XML format for unstructured grids (.vtu), one piece: points and lines between them, with inline
// base64 arrays and 64-bit headers. ParaView, VTK, PyVista and meshio read it.
#pragma once

#include <span>

#include "io/column.hpp"
#include "io/output_file.hpp"

namespace bondstatic {

struct LineGrid {
  std::span<const double> points;  ///< x, y, z of each point, one after the other
  std::span<const Index> lines;    ///< two point numbers a line
  std::span<const Column> point_data;
  std::span<const Column> line_data;
};

void write_vtu(OutputFile& file, const LineGrid& grid);

}  // namespace bondstatic
