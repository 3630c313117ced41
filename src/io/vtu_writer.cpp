#include "io/vtu_writer.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "io/base64.hpp"
#include "io/xml_text.hpp"

namespace bondstatic {

namespace {

constexpr std::uint8_t vtk_line = 3;
constexpr std::uint8_t vtk_duplicate_point = 1;
constexpr const char* ghost_array = "vtkGhostType";
constexpr const char* byte_order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

template <class T>
constexpr const char* vtk_type = "";
template <>
constexpr const char* vtk_type<double> = "Float64";
template <>
constexpr const char* vtk_type<Index> = "Int64";
template <>
constexpr const char* vtk_type<std::uint8_t> = "UInt8";

template <class... T>
void print(OutputFile& file, fmt::format_string<T...> format, T&&... values) {
  fmt::format_to(std::back_inserter(file.buffer()), format, std::forward<T>(values)...);
}

/// Uncompressed inline data is one base64 stream of the byte count (UInt64) and the values; `at` gives the
/// i-th of them.
template <class T, class At>
void write_array(OutputFile& file, const std::string& name, int components, Index count, At at) {
  print(file, "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n",
        vtk_type<T>, xml_text(name), components);
  constexpr Index header = sizeof(std::uint64_t), size = sizeof(T);
  write_base64(file, header + size * count, [&](Index begin, std::span<std::byte> into) {
    std::byte *out = into.data(), *const end = out + into.size();
    if (begin == 0) {
      const std::uint64_t bytes = std::uint64_t(size * count);
      std::memcpy(out, &bytes, header);
      out += header;
    }
    for (Index i = begin == 0 ? 0 : (begin - header) / size; out != end; ++i, out += size) {
      const T value = at(i);
      std::memcpy(out, &value, size);
    }
  });
  print(file, "\n</DataArray>\n");
}

void write_columns(OutputFile& file, std::span<const Column> columns) {
  for (const Column& column : columns)
    std::visit(
        [&]<class T>(const Column::Numbers<T>& at) {
          write_array<T>(file, column.name, column.components, column.count, at);
        },
        column.at);
}

void write_ghosts(OutputFile& file, const LineGrid& grid) {
  if (!grid.first_copy) return;
  write_array<std::uint8_t>(file, ghost_array, 1, Index(grid.points.size() / 3), [&](Index i) {
    return i < *grid.first_copy ? std::uint8_t(0) : vtk_duplicate_point;
  });
}

template <class T>
void declare_array(OutputFile& file, const std::string& name, int components) {
  print(file, "<PDataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"/>\n", vtk_type<T>,
        xml_text(name), components);
}

void declare_columns(OutputFile& file, std::span<const Column> columns) {
  for (const Column& column : columns)
    std::visit(
        [&]<class T>(const Column::Numbers<T>&) { declare_array<T>(file, column.name, column.components); },
        column.at);
}

void write_lines(OutputFile& file, std::span<const Index> ends) {
  const Index lines = Index(ends.size() / 2);
  write_array<Index>(file, "connectivity", 1, 2 * lines, [&](Index i) { return ends[std::size_t(i)]; });
  write_array<Index>(file, "offsets", 1, lines, [](Index i) { return 2 * (i + 1); });
  write_array<std::uint8_t>(file, "types", 1, lines, [](Index) { return vtk_line; });
}

}  // namespace

void write_vtu(OutputFile& file, const LineGrid& grid) {
  print(file, "<?xml version=\"1.0\"?>\n");
  print(file,
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n",
        byte_order);
  print(file, "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        grid.points.size() / 3, grid.lines.size() / 2);
  print(file, "<PointData>\n");
  write_columns(file, grid.point_data);
  write_ghosts(file, grid);
  print(file, "</PointData>\n<CellData>\n");
  write_columns(file, grid.line_data);
  print(file, "</CellData>\n<Points>\n");
  write_array<double>(file, "Points", 3, Index(grid.points.size()),
                      [&](Index i) { return grid.points[std::size_t(i)]; });
  print(file, "</Points>\n<Cells>\n");
  write_lines(file, grid.lines);
  print(file, "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

void write_pvtu(OutputFile& file, std::span<const Column> point_data, std::span<const Column> line_data,
                const std::vector<std::string>& pieces) {
  print(file, "<?xml version=\"1.0\"?>\n");
  print(file,
        "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n",
        byte_order);
  print(file, "<PUnstructuredGrid GhostLevel=\"0\">\n<PPointData>\n");
  declare_columns(file, point_data);
  declare_array<std::uint8_t>(file, ghost_array, 1);
  print(file, "</PPointData>\n<PCellData>\n");
  declare_columns(file, line_data);
  print(file, "</PCellData>\n<PPoints>\n");
  declare_array<double>(file, "Points", 3);
  print(file, "</PPoints>\n");
  for (const std::string& piece : pieces) print(file, "<Piece Source=\"{}\"/>\n", xml_text(piece));
  print(file, "</PUnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace bondstatic
