// The scene of a run: its grids as rows of numbers that a browser can hold.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/blocks.hpp"
#include "report/page_data.hpp"
#include "report/scene_state.hpp"

namespace bondstatic {

/// A model is drawn whole up to `particles` and `bonds`; of a larger one, a sample of what is too many. Of
/// many states, as many as make no more than `numbers` altogether, evenly spaced in each load case with its
/// last one; but at least two.
struct SceneLimits {
  Index particles = 150'000;
  Index bonds = 600'000;
  Index sampled_particles = 100'000;
  Index sampled_bonds = 150'000;
  Index numbers = 16'000'000;
};

/// Reads the states of one model, load case by load case; nothing where there is none, or no particle. `si`:
/// numbers are in SI units. Adds what was left out to `notes`, and what the bonds' forces and directions tell
/// as a whole, never as a sample, to `plots`. Throws Error (invalid_input) where a file is not as it was
/// written, or of another model than the first.
std::optional<PageScene> read_scene(const std::vector<SceneState>& states, bool si, const SceneLimits& limits,
                                    Blocks& blocks, std::vector<std::string>& notes,
                                    std::vector<PagePlot>& plots);

}  // namespace bondstatic
