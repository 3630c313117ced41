// What an explicit run holds: bodies, bonds, the order in which forces add up, energies so far.
#pragma once

#include "dynamics/advance_bonds.hpp"
#include "dynamics/bodies.hpp"
#include "dynamics/thread_choice.hpp"
#include "model/space_order.hpp"

namespace bondstatic {

class Archive;

/// A sum of millions of small terms that keeps what rounding would lose (Neumaier).
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    const bool larger = (sum_ < 0 ? -sum_ : sum_) >= (term < 0 ? -term : term);
    lost_ += larger ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + lost_; }
  friend void describe(Archive& archive, CompensatedSum& sum);

 private:
  double sum_ = 0, lost_ = 0;
};

/// Bonds that meet at a body, by lane number; twice the lane, plus one where the body is the bond's b. Summed
/// in this order, forces have the same bits whether bonds scatter them or bodies gather them.
struct EndsOfBody {
  std::vector<Index> offset;
  std::vector<Index> end;
};
EndsOfBody ends_of_bodies(const std::vector<BondPack>& packs, Index bodies);

/// What the blocks of bodies and of packs did in a step.
struct BlockSums {
  std::vector<StepSums> bodies, packs;
};

struct ExplicitRun::Data {
  /// Bodies and bonds of a large model stand along a curve through space, whatever the order of its
  /// particles: all that is below is numbered so. Both are empty where it is the model's own order.
  SpaceOrder order;
  std::vector<Index> body_of_particle;

  std::vector<BondProperties> properties;
  std::vector<Index> bond_of_lane;
  Boundary boundary;
  DynamicOptions options;
  std::string name;  ///< of the load case

  Bodies bodies;
  std::vector<BondPack> packs;
  std::vector<DashpotPack> dashpots;  ///< empty where there is none
  EndsOfBody ends_of_body;            ///< for several threads only
  std::vector<EndForces> ends;        ///< likewise

  ThreadChoice thread_choice;

  Index step = 0;
  CompensatedSum work, dissipated;
  double initial_energy = 0;

  void set_up(const Model& model, Index load_case, const std::vector<bool>& left_out);
  Index body_of(Index particle) const {
    return body_of_particle.empty() ? particle : body_of_particle[std::size_t(particle)];
  }
  Index particle_of(Index body) const {
    return order.particle.empty() ? body : order.particle[std::size_t(body)];
  }

  double factor_at(Index at_step) const;  ///< of the ramp
  Loading loading() const { return {factor_at(step), factor_at(step + 1)}; }

  void begin();  ///< from step 0: velocities back by half a step
  StepSums move_block(Index block, const Loading& now);
  StepSums advance_block(Index block, EndForces* kept);
  void add_up(const BlockSums& sums);
  void one_step();
  void carry(Archive& archive);  ///< everything that changes, out or in
  void steps_on_threads(Index steps);
};

}  // namespace bondstatic
