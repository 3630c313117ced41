// What reading a case gathers on the way, and reading single values of the tree.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/case_file.hpp"
#include "bondstatic/types.hpp"
#include "bondstatic/units.hpp"
#include "case/node.hpp"

namespace bondstatic {

struct Reading {
  std::string file;                       ///< as given
  std::filesystem::path folder;           ///< of the case file: paths in it are relative to this
  std::filesystem::path resolved_folder;  ///< where the resolved case will lie; empty: leave paths alone
  Purpose purpose = Purpose::statics;
  std::vector<Fault> faults;
  std::vector<std::string> warnings;
  bool si = false;  ///< a number carried a unit
  int threads = 1;  ///< for what is long; nothing that is read or said depends on it

  void fault(const Place& place, const std::string& message, const std::string& cure) {
    faults.push_back({place, message, cure});
  }
};

enum class Allowed { any, not_negative, positive };

/// Each reads one value; where it is not what is asked for, the fault names `name` and nothing is returned.
/// Numbers are finite; a text with a unit is a number in SI.
std::optional<double> read_number(Reading& reading, const Node& node, const std::string& name,
                                  Dimension dimension, Allowed allowed = Allowed::any);
std::optional<Vector3> read_vector(Reading& reading, const Node& node, const std::string& name,
                                   Dimension dimension);
std::optional<Index> read_whole(Reading& reading, const Node& node, const std::string& name, Index lowest);
std::optional<bool> read_truth(Reading& reading, const Node& node, const std::string& name);
std::optional<std::string> read_text(Reading& reading, const Node& node, const std::string& name);

/// A text or a list of them.
std::optional<std::vector<std::string>> read_texts(Reading& reading, const Node& node,
                                                   const std::string& name);

/// The path that a text names, relative paths taken from the case's folder. Rewritten in the tree for where
/// the resolved case will lie.
std::string resolve_path(const Reading& reading, Node& text);

/// "x", "y", "z" or a vector other than zero; returned as a unit vector.
std::optional<Vector3> read_axis(Reading& reading, const Node& node, const std::string& name);

}  // namespace bondstatic
