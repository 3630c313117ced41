// Grids as VTK's own readers see them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "io/scratch_folder.hpp"

namespace bondstatic::test {

/// What VTK (python3-vtk9) finds in a .vtu or .pvtu; lines of read_vtu.py by their first words.
inline std::map<std::string, std::string> read_by_vtk(const std::string& file, const ScratchFolder& scratch) {
  const std::string out = (scratch / "vtk.txt").string();
  const std::string command = fmt::format("/usr/bin/python3 -B '{}/tests/io/read_vtu.py' '{}' > '{}' 2>&1",
                                          BONDSTATIC_SOURCE_DIR, file, out);
  const int status = std::system(command.c_str());
  const std::string text = read_text(out);
  if (status != 0) ADD_FAILURE() << "VTK (package python3-vtk9) could not read " << file << ":\n" << text;
  std::map<std::string, std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    const int more = key == "array" ? 2 : key == "cell" ? 1 : 0;
    for (int i = 0; i < more && words >> word; ++i) key += " " + word;
    std::getline(words >> std::ws, found[key]);
  }
  return found;
}

}  // namespace bondstatic::test
