// One step of a DEM run as dumps and tables hold it.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

struct ParticleState {
  Index step = 0;
  double time = not_given;
  std::vector<Index> id;
  std::vector<Vector3> position;                ///< unwrapped where the file tells images
  bool unwrapped = false;                       ///< positions do not jump at periodic faces
  std::vector<Eigen::Quaterniond> orientation;  ///< from the start of the run; empty where not written
  std::vector<Vector3> velocity, angular_velocity, force, torque;  ///< empty where not written
  std::vector<double> radius;                                      ///< empty where not written
  std::vector<Index> type;                                         ///< empty where not written
  std::optional<Cell> cell;                                        ///< only where some direction is periodic
  std::vector<std::string> notes;  ///< what a user must know of the reading, each a full sentence
};

/// Bonds of a step, rows in the file's order; columns under the file's names.
struct BondState {
  Index step = 0;
  std::vector<Index> a, b;  ///< particle ids
  std::map<std::string, std::vector<double>> columns;
  std::vector<std::string> notes;  ///< as above
};

}  // namespace bondstatic
