#include "io/vtu_writer.hpp"

#include <bit>
#include <cstdint>
#include <iterator>
#include <vector>

#include "io/base64.hpp"

namespace bondstatic {

namespace {

constexpr std::uint8_t vtk_line = 3;

template <class T>
constexpr const char* vtk_type = "";
template <>
constexpr const char* vtk_type<double> = "Float64";
template <>
constexpr const char* vtk_type<Index> = "Int64";
template <>
constexpr const char* vtk_type<std::uint8_t> = "UInt8";

std::string attribute_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

template <class... T>
void print(OutputFile& file, fmt::format_string<T...> format, T&&... values) {
  fmt::format_to(std::back_inserter(file.buffer()), format, std::forward<T>(values)...);
}

/// Uncompressed inline data is one base64 stream of the byte count (UInt64) and the values.
template <class T>
void write_array(OutputFile& file, const std::string& name, int components, std::span<const T> values) {
  print(file, "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n",
        vtk_type<T>, attribute_text(name), components);
  Base64Stream stream(file);
  const std::uint64_t bytes = values.size_bytes();
  stream.append(std::as_bytes(std::span(&bytes, 1)));
  stream.append(std::as_bytes(values));
  stream.finish();
  print(file, "\n</DataArray>\n");
}

void write_columns(OutputFile& file, std::span<const Column> columns) {
  for (const Column& column : columns)
    std::visit(
        [&](const auto& values) { write_array(file, column.name, column.components, std::span(values)); },
        column.values);
}

void write_lines(OutputFile& file, std::span<const Index> ends) {
  const std::size_t lines = ends.size() / 2;
  std::vector<Index> offsets(lines);
  for (std::size_t i = 0; i < lines; ++i) offsets[i] = Index(2 * (i + 1));
  const std::vector<std::uint8_t> types(lines, vtk_line);
  write_array(file, "connectivity", 1, ends);
  write_array(file, "offsets", 1, std::span<const Index>(offsets));
  write_array(file, "types", 1, std::span<const std::uint8_t>(types));
}

}  // namespace

void write_vtu(OutputFile& file, const LineGrid& grid) {
  constexpr const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  print(file, "<?xml version=\"1.0\"?>\n");
  print(file,
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n",
        order);
  print(file, "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        grid.points.size() / 3, grid.lines.size() / 2);
  print(file, "<PointData>\n");
  write_columns(file, grid.point_data);
  print(file, "</PointData>\n<CellData>\n");
  write_columns(file, grid.line_data);
  print(file, "</CellData>\n<Points>\n");
  write_array(file, "Points", 3, grid.points);
  print(file, "</Points>\n<Cells>\n");
  write_lines(file, grid.lines);
  print(file, "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace bondstatic
