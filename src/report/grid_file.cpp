#include "report/grid_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "bondstatic/error.hpp"
#include "io/base64.hpp"

namespace bondstatic {

namespace {

constexpr const char* ghost_array = "vtkGhostType";
constexpr const char* byte_order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
constexpr std::uint8_t line_type = 3;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

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
  // Parsed where it was read to. What is between tags is one string, however long.
  const pugi::xml_parse_result parsed =
      xml_->load_file(path.c_str(), pugi::parse_minimal, pugi::encoding_utf8);
  if (parsed.status == pugi::status_out_of_memory)
    throw MemoryError(fmt::format("{}: does not fit in memory\n    cure: use a machine with more", path));
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
  // Positions are always there: a count that they do not bear out must not be trusted with memory.
  const std::size_t letters = trimmed(piece_.child("Points").child_value("DataArray")).size();
  if (letters / 32 != std::size_t(points_))
    fail(fmt::format("NumberOfPoints is {}, but there are {} letters of positions", points_, letters));
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
  const auto decoded = std::string_view(node.attribute("format").value()) == "binary"
                           ? decode_base64(trimmed(node.child_value()))
                           : std::nullopt;
  std::uint64_t size = 0;
  if (!decoded || decoded->size() < sizeof size) fail(fmt::format("array {} is damaged, no base64", name));
  std::memcpy(&size, decoded->data(), sizeof size);
  const std::size_t bytes = decoded->size() - sizeof size;
  const auto components = std::size_t(std::max(1, node.attribute("NumberOfComponents").as_int(1)));
  const std::size_t count = bytes / sizeof(Stored);
  if (size != bytes || bytes % sizeof(Stored) != 0 || count % components != 0 ||
      count / components != std::size_t(rows))
    fail(fmt::format("array {} is damaged: {} bytes are no {} rows of {} numbers", name, bytes, rows,
                     components));
  numbers.reserve(numbers.size() + count);
  const std::byte* from = decoded->data() + sizeof size;
  for (std::size_t i = 0; i < count; ++i, from += sizeof(Stored)) {
    Stored value;
    std::memcpy(&value, from, sizeof value);
    numbers.push_back(Number(value));
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
