// Cases for the commands that run through time, and what their results have in common.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic::test {

/// BONDSTATIC_FULL=1 asks for the long variants.
inline bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

/// The cantilever with mass; at rest after some ten thousand steps, which take some hundredths of a second.
inline std::string heavy_cantilever() {
  std::string text = cantilever();
  const std::string before = "[[bonds]]";
  return text.insert(text.find(before), "density = 7850\n");
}

/// The same under two load cases, "down" with the output "tip" and "twist" with the output "turn".
inline std::string two_load_cases() {
  std::string text = heavy_cantilever();
  text.insert(text.find("force = "), "case = \"down\"\n");
  return text + R"(case = "down"
[[loads]]
at = { id = 11 }
moment = [1e5, 0, 0]
case = "twist"
[[outputs]]
name = "turn"
of = "rx"
at = { id = 11 }
case = "twist"
)";
}

/// Hardly damped: the run takes about a second.
inline const char* const long_run = "dynamics.particle_damping=0.01";

inline const char* const checkpoint_name = "relax.checkpoint";

/// Without what differs between two runs of one case.
inline nlohmann::json without_timings(nlohmann::json summary) {
  summary.erase("planning_seconds");
  summary.erase("threads");
  for (auto& load_case : summary.at("load_cases")) load_case.erase("seconds");
  return summary;
}

inline nlohmann::json read_json(const std::filesystem::path& file) {
  return nlohmann::json::parse(read_text(file));
}

/// The files below a folder, by name, with what must be the same in two runs of one case.
inline std::map<std::string, std::string> results_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> results;
  for (const std::string& name : everything_in(folder)) {
    if (std::filesystem::is_directory(folder / name)) continue;
    const bool summary = name == "summary.json";
    results[name] = summary ? without_timings(read_json(folder / name)).dump() : read_text(folder / name);
  }
  return results;
}

/// Names the files that differ: their contents are too long to be shown.
inline void expect_same_results(const std::map<std::string, std::string>& found,
                                const std::map<std::string, std::string>& expected) {
  for (const auto& [name, content] : found) {
    EXPECT_TRUE(expected.contains(name)) << name << " should not be there";
    if (expected.contains(name)) {
      EXPECT_TRUE(content == expected.at(name)) << name << " differs";
    }
  }
  for (const auto& [name, content] : expected) EXPECT_TRUE(found.contains(name)) << name << " is missing";
}

}  // namespace bondstatic::test
