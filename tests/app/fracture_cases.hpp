// Cases for the fracture command, and what their results have in common.
#pragma once

#include "app/relax_cases.hpp"

namespace bondstatic::test {

inline const char* const fracture_checkpoint = "fracture.checkpoint";
inline const char* const unfinished = "fracture.unfinished";

/// Eight fibres between rigid rows, k = 100; their strengths scatter between 5 and 15.
inline std::string fibre_bundle() {
  return R"(title = "bundle"
[[particles]]
line = { from = [0, 0, 0], to = [14, 0, 0], count = 8 }
radius = 0.5
group = "foot"
[[particles]]
line = { from = [0, 0, 1], to = [14, 0, 1], count = 8 }
radius = 0.5
group = "head"
[[bonds]]
law = "contact"
kn = 100
ks = 100
[bonds.strength]
criterion = "contact-bond"
critical_tensile_force = 10
critical_shear_force = 1e9
scatter = "uniform"
range = { critical_tensile_force = 5 }
seed = 7
[[supports]]
at = { group = "foot" }
fix = "all"
[[supports]]
at = { group = "head" }
fix = "all"
values = { z = 1 }
[fracture]
control = "displacement"
[[outputs]]
name = "force"
of = "reaction_fz"
at = { group = "head" }
reduce = "sum"
)";
}

/// A block that is pulled apart; its breaks take some tenths of a second.
inline std::string pulled_block() {
  return R"(title = "block"
[[particles]]
lattice = { kind = "simple-cubic", count = [7, 7, 9], spacing = 1 }
radius = 0.5
[[bonds]]
law = "timoshenko"
young = 1e6
poisson = 0.2
radius = 0.3
strength = { criterion = "brown", tensile_strength = 1e3, shear_strength = 1e3, scatter = "weibull", modulus = 3, seed = 5 }
[[supports]]
at = { lowest = { axis = "z", within = 0.1 } }
fix = "all"
[[supports]]
at = { highest = { axis = "z", within = 0.1 } }
fix = "all"
values = { z = 1e-3 }
[fracture]
control = "displacement"
max_breaks = 250
save_every = 50
[[outputs]]
name = "force"
of = "reaction_fz"
at = { lowest = { axis = "z", within = 0.1 } }
reduce = "sum"
)";
}

/// What must be the same in two runs of one case; a run that goes on factorises once more, and on a busy
/// machine one takes fewer threads than another.
inline std::string comparable(const std::string& summary_text) {
  auto summary = nlohmann::json::parse(summary_text);
  summary.erase("seconds");
  for (const char* work : {"factorisations", "analyses", "threads"}) summary.at("solver").erase(work);
  return summary.dump();
}

/// As results_in(), of a run of fracture.
inline std::map<std::string, std::string> fracture_results_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> results;
  for (const std::string& name : everything_in(folder)) {
    if (std::filesystem::is_directory(folder / name)) continue;
    const std::string content = read_text(folder / name);
    results[name] = name == "summary.json" ? comparable(content) : content;
  }
  return results;
}

}  // namespace bondstatic::test
