// A state that a folder of results has as a grid.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace bondstatic {

struct SceneState {
  std::vector<std::string> files;  ///< paths of .vtu files: one, or a piece a rank
  std::string load_case;
  std::string label;
  std::optional<double> step;
};

}  // namespace bondstatic
