// One .vtu file as io/vtu_writer writes it: points, lines between them, and arrays of both. Only its XML is
// kept in memory; arrays are read from the file when they are asked for.
#pragma once

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

struct GridArray {
  std::string name;
  int components = 1;
  bool whole = false;  ///< Int64; Float64 otherwise

  bool operator==(const GridArray&) const = default;
};

/// Every function throws Error (invalid_input) that names the file where it cannot be read, or is not as it
/// was written.
class GridFile {
 public:
  enum class Of { points, lines };

  explicit GridFile(const std::string& path);

  const std::string& path() const { return path_; }
  Index count(Of of) const { return of == Of::points ? points_ : lines_; }

  /// Without vtkGhostType.
  std::vector<GridArray> arrays(Of of) const;
  /// Appends an array, row by row. Whole ones can be had as both.
  void append(Of of, const std::string& array, std::vector<double>& numbers) const;
  void append(Of of, const std::string& array, std::vector<Index>& numbers) const;

  void append_positions(std::vector<double>& positions) const;  ///< x, y, z; finite
  void append_ends(std::vector<Index>& ends) const;             ///< two points of this file a line
  void append_copies(std::vector<bool>& copies) const;          ///< of each point, from vtkGhostType

 private:
  [[noreturn]] void fail(const std::string& found) const;
  /// The XML, and where the appended data lie; all of the file, up to a limit, where there are none.
  std::string read_xml();
  Index count_named(const char* attribute) const;
  pugi::xml_node group(Of of) const;
  pugi::xml_node cells(const char* array, const char* type) const;
  /// Of rows of numbers that are stored as another kind.
  template <class Stored, class Number>
  void append_as(pugi::xml_node array, Index rows, std::vector<Number>& numbers) const;
  template <class Number>
  void append_numbers(Of of, const std::string& array, std::vector<Number>& numbers) const;

  std::string path_;
  std::unique_ptr<pugi::xml_document> xml_;
  pugi::xml_node piece_;
  Index points_ = 0, lines_ = 0;
  std::uint64_t data_ = 0, end_ = 0;  ///< bytes [data_, end_) of the file are appended arrays
};

}  // namespace bondstatic
