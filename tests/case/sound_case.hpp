// A sound case to spoil, and reading a case from text.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bondstatic/case_file.hpp"
#include "bondstatic/error.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic::test {

inline const std::vector<std::string>& sound_lines() {
  static const std::vector<std::string> lines{
      "[[particles]]",                                            // 1
      "line = { from = [0, 0, 0], to = [4, 0, 0], count = 11 }",  // 2
      "radius = 0.2",                                             // 3
      "[[bonds]]",                                                // 4
      "law = \"timoshenko\"",                                     // 5
      "young = 200e9",                                            // 6
      "poisson = 0.3",                                            // 7
      "radius = 0.2",                                             // 8
      "[[supports]]",                                             // 9
      "at = { id = 1 }",                                          // 10
      "fix = \"all\"",                                            // 11
      "[[loads]]",                                                // 12
      "at = { id = 11 }",                                         // 13
      "force = [0, -100e3, 0]",                                   // 14
      "[[outputs]]",                                              // 15
      "name = \"tip\"",                                           // 16
      "of = \"uy\"",                                              // 17
      "at = { id = 11 }",                                         // 18
  };
  return lines;
}

/// The sound case with some lines, counted from 1, replaced; line 19 is appended.
inline std::string sound_case(const std::vector<std::pair<int, std::string>>& replaced = {}) {
  std::vector<std::string> lines = sound_lines();
  lines.emplace_back();
  for (const auto& [line, text] : replaced) lines.at(std::size_t(line - 1)) = text;
  std::string out;
  for (const std::string& line : lines) out += line + '\n';
  return out;
}

/// Reads the text as a case file beside the given files (name, content).
inline Case read_case_text(const std::string& text, const std::vector<std::string>& overrides = {},
                           const std::vector<std::pair<std::string, std::string>>& files = {},
                           Purpose purpose = Purpose::statics) {
  const ScratchFolder folder;
  for (const auto& [name, content] : files) folder.write(name, content);
  return read_case(folder.write("case.toml", text), overrides, "", purpose);
}

/// What is wrong with it; empty where it reads. Places carry the bare file name.
inline std::vector<Fault> faults_of(const std::string& text, const std::vector<std::string>& overrides = {},
                                    const std::vector<std::pair<std::string, std::string>>& files = {},
                                    Purpose purpose = Purpose::statics) {
  try {
    read_case_text(text, overrides, files, purpose);
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults)
      if (fault.place.line > 0)
        fault.place.file = std::filesystem::path(fault.place.file).filename().string();
    return faults;
  }
  return {};
}

}  // namespace bondstatic::test
