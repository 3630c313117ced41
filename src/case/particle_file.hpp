// A packing in a file.
#pragma once

#include <optional>
#include <vector>

#include "bondstatic/model.hpp"
#include "case/row_places.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

struct ParticleRows {
  std::vector<Particle> particles;  ///< id -1, radius and density NaN where the file has no such column
  RowPlaces places;                 ///< of each row; empty where they are from no file
  std::vector<std::string> groups;  ///< of each row; empty where there is no such column
  std::optional<Cell> cell;         ///< of another code's file, where it is periodic
  bool has_id = false, has_radius = false, has_density = false;
};

/// A table with columns x, y, z and optionally id, radius or diameter, density, group, with their usual
/// aliases; others are named in a warning. Or a file of another code (case/foreign_file.hpp).
std::optional<ParticleRows> read_particle_file(TableReader& block);

}  // namespace bondstatic
