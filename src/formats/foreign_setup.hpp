// What a run's script does to its model, in this project's words: who is held, what is loaded.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

struct ForeignGroup {
  std::string name;
  std::vector<Index> members;  ///< ascending positions in ForeignModel::particles; never empty
};

struct ForeignSupport {
  std::string group;            ///< one of ForeignSetup::groups, or "all"
  std::array<bool, 6> fixed{};  ///< x, y, z, rx, ry, rz
  std::string origin;           ///< "fix 4 fixed freeze"
};

struct ForeignLoad {
  std::string group;
  Vector3 value = Vector3::Zero();
  bool gravity = false;  ///< `value` is an acceleration; else the force on each particle of the group
  std::string origin;
};

struct ForeignSetup {
  std::vector<ForeignGroup> groups;
  std::vector<ForeignSupport> supports;
  std::vector<ForeignLoad> loads;
};

}  // namespace bondstatic
