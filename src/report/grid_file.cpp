#include "report/grid_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

constexpr const char* ghost_array = "vtkGhostType";
constexpr const char* byte_order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
constexpr std::uint8_t line_type = 3;

constexpr std::string_view begin_of_data = "<AppendedData encoding=\"raw\">\n_";
constexpr std::string_view end_of_data = "\n</AppendedData>\n</VTKFile>\n";

}  // namespace

void GridFile::fail(const std::string& found) const {
  throw InputError({{{path_},
                     found,
                     "solve the case again, which writes the grid anew; grids that other programs wrote are "
                     "not read"}});
}

GridFile::GridFile(const std::string& path) : path_(path), xml_(std::make_unique<pugi::xml_document>()) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    fail(std::filesystem::exists(path, error) ? "is no file" : "does not exist");
  const std::string xml = read_xml();
  const pugi::xml_parse_result parsed =
      xml_->load_buffer(xml.data(), xml.size(), pugi::parse_minimal, pugi::encoding_utf8);
  if (!parsed) fail(fmt::format("damaged at byte {}: {}", parsed.offset, parsed.description()));

  const pugi::xml_node root = xml_->child("VTKFile");
  const std::string_view type = root.attribute("type").value();
  if (type != "UnstructuredGrid")
    fail(fmt::format("found {}, no grid of VTK (VTKFile of type UnstructuredGrid)",
                     !root          ? "no VTKFile"
                     : type.empty() ? "a VTKFile without type"
                                    : fmt::format("a VTKFile of type {}", type)));
  for (const auto& [name, expected] :
       {std::pair("byte_order", byte_order), std::pair("header_type", "UInt64"), std::pair("compressor", "")})
    if (std::string_view(root.attribute(name).value()) != expected)
      fail(fmt::format("{} is \"{}\", not \"{}\"", name, root.attribute(name).value(), expected));
  const pugi::xml_node grid = root.child("UnstructuredGrid");
  piece_ = grid.child("Piece");
  if (!piece_ || piece_.next_sibling("Piece")) fail("found no single Piece of an UnstructuredGrid");
  points_ = count_named("NumberOfPoints");
  lines_ = count_named("NumberOfCells");
  if (data_ == 0) fail("has no appended raw data");
  // Counts that the bytes of the file do not bear out must not be trusted with memory.
  if (24 * std::uint64_t(points_) + 17 * std::uint64_t(lines_) > end_ - data_)
    fail(fmt::format("{} points and {} lines do not go into {} bytes", points_, lines_, end_ - data_));
}

std::string GridFile::read_xml() {
  constexpr std::size_t piece = std::size_t(1) << 16, longest = std::size_t(1) << 24;
  std::ifstream file(path_, std::ios::binary);
  if (!file) fail("cannot be read");
  std::string text;
  while (file) {
    if (text.size() >= longest) fail(fmt::format("has no appended raw data in its first {} bytes", longest));
    const std::size_t before = text.size();
    text.resize(before + piece);
    file.read(text.data() + before, piece);
    text.resize(before + std::size_t(file.gcount()));
    const std::size_t seen = before - std::min(before, begin_of_data.size());
    const std::size_t found = text.find(begin_of_data, seen);
    if (found == std::string::npos) continue;
    data_ = found + begin_of_data.size();
    text.resize(data_);
    break;
  }
  if (data_ == 0) return text;

  std::string last(end_of_data.size(), ' ');
  file.clear();
  file.seekg(-std::streamoff(last.size()), std::ios::end);
  end_ = std::uint64_t(std::max(std::streamoff(0), std::streamoff(file.tellg())));
  if (!file.read(last.data(), std::streamsize(last.size())) || last != end_of_data || end_ < data_)
    fail("damaged: it does not end as it was written");
  return text.append(end_of_data);
}

Index GridFile::count_named(const char* attribute) const {
  const std::string_view text = piece_.attribute(attribute).value();
  Index count = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  constexpr Index most = Index(1) << 48;
  if (error != std::errc() || end != text.data() + text.size() || count < 0 || count > most)
    fail(fmt::format("{} is \"{}\", no count", attribute, text));
  return count;
}

pugi::xml_node GridFile::group(Of of) const {
  return piece_.child(of == Of::points ? "PointData" : "CellData");
}

std::vector<GridArray> GridFile::arrays(Of of) const {
  std::vector<GridArray> arrays;
  for (const pugi::xml_node node : group(of).children("DataArray")) {
    const std::string name = node.attribute("Name").value();
    if (name == ghost_array) continue;
    const std::string_view type = node.attribute("type").value();
    const int components = node.attribute("NumberOfComponents").as_int(1);
    if (type != "Float64" && type != "Int64")
      fail(fmt::format("array {} is of type {}, not Float64 or Int64", name, type));
    if (components != 1 && components != 3)
      fail(fmt::format("array {} has {} components, not 1 or 3", name, components));
    arrays.push_back({name, components, type == "Int64"});
  }
  return arrays;
}

template <class Stored, class Number>
void GridFile::append_as(pugi::xml_node node, Index rows, std::vector<Number>& numbers) const {
  const std::string name = node.attribute("Name").value();
  const pugi::xml_attribute offset = node.attribute("offset");
  const std::uint64_t begin = data_ + std::min<std::uint64_t>(offset.as_ullong(), end_ - data_);
  std::uint64_t bytes = 0;
  std::ifstream file(path_, std::ios::binary);
  file.seekg(std::streamoff(begin));
  if (std::string_view(node.attribute("format").value()) != "appended" || offset.empty() ||
      end_ - begin < sizeof bytes || !file.read(reinterpret_cast<char*>(&bytes), sizeof bytes) ||
      end_ - begin - sizeof bytes < bytes)
    fail(fmt::format("array {} is damaged: its numbers are not in the appended data", name));
  const auto components = std::size_t(std::max(1, node.attribute("NumberOfComponents").as_int(1)));
  const std::size_t count = bytes / sizeof(Stored);
  if (bytes % sizeof(Stored) != 0 || count % components != 0 || count / components != std::size_t(rows))
    fail(fmt::format("array {} is damaged: {} bytes are no {} rows of {} numbers", name, bytes, rows,
                     components));
  numbers.reserve(numbers.size() + count);
  std::array<Stored, 4096> some;
  for (std::size_t left = count; left > 0;) {
    const std::size_t now = std::min(left, some.size());
    if (!file.read(reinterpret_cast<char*>(some.data()), std::streamsize(now * sizeof(Stored))))
      fail(fmt::format("array {} cannot be read", name));
    for (std::size_t i = 0; i < now; ++i) numbers.push_back(Number(some[i]));
    left -= now;
  }
}

template <class Number>
void GridFile::append_numbers(Of of, const std::string& array, std::vector<Number>& numbers) const {
  const pugi::xml_node node = group(of).find_child_by_attribute("DataArray", "Name", array.c_str());
  if (!node) fail(fmt::format("has no array {}", array));
  if (std::string_view(node.attribute("type").value()) == "Int64")
    return append_as<Index>(node, count(of), numbers);
  if constexpr (std::is_same_v<Number, double>) return append_as<double>(node, count(of), numbers);
  fail(fmt::format("array {} is not one of whole numbers", array));
}

void GridFile::append(Of of, const std::string& array, std::vector<double>& numbers) const {
  append_numbers(of, array, numbers);
}

void GridFile::append(Of of, const std::string& array, std::vector<Index>& numbers) const {
  append_numbers(of, array, numbers);
}

void GridFile::append_positions(std::vector<double>& positions) const {
  const pugi::xml_node node = piece_.child("Points").child("DataArray");
  if (!node || node.attribute("NumberOfComponents").as_int() != 3 ||
      std::string_view(node.attribute("type").value()) != "Float64")
    fail("has no points of three Float64");
  const std::size_t begin = positions.size();
  append_as<double>(node, points_, positions);
  for (std::size_t i = begin; i < positions.size(); ++i)
    if (!std::isfinite(positions[i])) fail(fmt::format("point {} lies nowhere", (i - begin) / 3));
}

pugi::xml_node GridFile::cells(const char* array, const char* type) const {
  const pugi::xml_node node = piece_.child("Cells").find_child_by_attribute("DataArray", "Name", array);
  if (!node || std::string_view(node.attribute("type").value()) != type)
    fail(fmt::format("has no array {} of {}", array, type));
  return node;
}

void GridFile::append_ends(std::vector<Index>& ends) const {
  std::vector<Index> types, offsets;
  append_as<std::uint8_t>(cells("types", "UInt8"), lines_, types);
  append_as<Index>(cells("offsets", "Int64"), lines_, offsets);
  for (std::size_t k = 0; k < types.size(); ++k)
    if (types[k] != line_type || offsets[k] != 2 * Index(k + 1)) fail(fmt::format("cell {} is no line", k));
  const std::size_t begin = ends.size();
  append_as<Index>(cells("connectivity", "Int64"), 2 * lines_, ends);
  for (std::size_t i = begin; i < ends.size(); ++i)
    if (ends[i] < 0 || ends[i] >= points_)
      fail(fmt::format("line {} ends at point {} of {}", (i - begin) / 2, ends[i], points_));
}

void GridFile::append_copies(std::vector<bool>& copies) const {
  const pugi::xml_node data = group(Of::points);
  const pugi::xml_node node = data.find_child_by_attribute("DataArray", "Name", ghost_array);
  if (!node) return copies.resize(copies.size() + std::size_t(points_));
  std::vector<Index> marks;
  append_as<std::uint8_t>(node, points_, marks);
  for (const Index mark : marks) copies.push_back(mark != 0);
}

}  // namespace bondstatic
