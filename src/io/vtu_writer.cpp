#include "io/vtu_writer.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>

#include "io/ordered_blocks.hpp"
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

/// Arrays are declared in the XML; their numbers follow behind it, one array after the other, each with its
/// count of bytes (UInt64) before it: VTK's appended raw data.
class AppendedArrays {
 public:
  /// `at` gives the i-th number, and is asked for it by write().
  template <class T, class At>
  void declare(OutputFile& file, const std::string& name, int components, Index count, At at) {
    print(
        file,
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        vtk_type<T>, xml_text(name), components, bytes_);
    bytes_ += header + Index(sizeof(T)) * count;
    writers_.push_back([count, at](OutputFile& into) { write_numbers<T>(into, count, at); });
  }

  void declare(OutputFile& file, std::span<const Column> columns) {
    for (const Column& column : columns)
      std::visit(
          [&]<class T>(const Column::Numbers<T>& at) {
            declare<T>(file, column.name, column.components, column.count, std::cref(at));
          },
          column.at);
  }

  void write(OutputFile& file) const {
    print(file, "<AppendedData encoding=\"raw\">\n_");
    for (const auto& write_array : writers_) write_array(file);
    print(file, "\n</AppendedData>\n");
  }

 private:
  static constexpr Index header = sizeof(std::uint64_t);

  template <class T, class At>
  static void write_numbers(OutputFile& file, Index count, At at) {
    const std::uint64_t bytes = sizeof(T) * std::uint64_t(count);
    file.append({reinterpret_cast<const char*>(&bytes), header});
    constexpr Index block = (Index(1) << 20) / Index(sizeof(T));
    write_blocks(file, count, block, [&](Index begin, Index end, fmt::memory_buffer& into) {
      into.resize(std::size_t(end - begin) * sizeof(T));
      char* out = into.data();
      for (Index i = begin; i < end; ++i, out += sizeof(T)) {
        const T value = at(i);
        std::memcpy(out, &value, sizeof(T));
      }
    });
  }

  Index bytes_ = 0;
  std::vector<std::function<void(OutputFile&)>> writers_;
};

void declare_ghosts(AppendedArrays& arrays, OutputFile& file, const LineGrid& grid) {
  if (!grid.first_copy) return;
  arrays.declare<std::uint8_t>(
      file, ghost_array, 1, Index(grid.points.size() / 3),
      [first = *grid.first_copy](Index i) { return i < first ? std::uint8_t(0) : vtk_duplicate_point; });
}

void declare_lines(AppendedArrays& arrays, OutputFile& file, std::span<const Index> ends) {
  const Index lines = Index(ends.size() / 2);
  arrays.declare<Index>(file, "connectivity", 1, 2 * lines, [ends](Index i) { return ends[std::size_t(i)]; });
  arrays.declare<Index>(file, "offsets", 1, lines, [](Index i) { return 2 * (i + 1); });
  arrays.declare<std::uint8_t>(file, "types", 1, lines, [](Index) { return vtk_line; });
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

}  // namespace

void write_vtu(OutputFile& file, const LineGrid& grid) {
  AppendedArrays arrays;
  print(file, "<?xml version=\"1.0\"?>\n");
  print(file,
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n",
        byte_order);
  print(file, "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        grid.points.size() / 3, grid.lines.size() / 2);
  print(file, "<PointData>\n");
  arrays.declare(file, grid.point_data);
  declare_ghosts(arrays, file, grid);
  print(file, "</PointData>\n<CellData>\n");
  arrays.declare(file, grid.line_data);
  print(file, "</CellData>\n<Points>\n");
  arrays.declare<double>(file, "Points", 3, Index(grid.points.size()),
                         [points = grid.points](Index i) { return points[std::size_t(i)]; });
  print(file, "</Points>\n<Cells>\n");
  declare_lines(arrays, file, grid.lines);
  print(file, "</Cells>\n</Piece>\n</UnstructuredGrid>\n");
  arrays.write(file);
  print(file, "</VTKFile>\n");
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
