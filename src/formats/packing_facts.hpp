// What a packing from a file looks like, before any law.
#pragma once

#include "formats/foreign_model.hpp"
#include "io/id_table.hpp"

namespace bondstatic {

/// Where the ends of a model's bonds are. Every bond's particles must be there, with ids of their own.
class BondEnds {
 public:
  explicit BondEnds(const ForeignModel& model);

  Index a(std::size_t bond) const { return *position_.position_of(model_.bonds[bond].a); }
  Index b(std::size_t bond) const { return *position_.position_of(model_.bonds[bond].b); }
  /// From a to b; in a periodic cell to the nearest image of b.
  Vector3 branch(std::size_t bond) const;

 private:
  const ForeignModel& model_;
  IdTable position_;
};

struct PackingFacts {
  Vector3 lowest = Vector3::Zero(), highest = Vector3::Zero();  ///< of the particles' centres
  double smallest_radius = not_given, largest_radius = not_given;
  double coordination = 0;  ///< bonds a particle, each counted at both ends
  Index bodies = 0;         ///< that bonds connect; single particles are not counted
  Index loose = 0;          ///< particles without a bond
  Index largest_body = 0;   ///< particles of it
};
PackingFacts packing_facts(const ForeignModel& model);

}  // namespace bondstatic
