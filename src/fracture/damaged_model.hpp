// The model as it is after some bonds have broken: what is left of it, and its two motions, under the loads
// that stay and per unit of factor under those that scale. Each is refined as a plain solve's is, from where
// it was before the last break.
#pragma once

#include <memory>
#include <vector>

#include "bondstatic/fracture.hpp"
#include "bondstatic/network.hpp"
#include "fracture/load_path.hpp"
#include "fracture/low_rank_solver.hpp"
#include "fracture/next_break.hpp"
#include "io/archive.hpp"
#include "system/extended.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// Strain energy at a factor: (held . held + 2 factor held . scaled + factor^2 scaled . scaled) / 2.
struct StrainEnergy {
  double held = 0;
  double mixed = 0;
  double scaled = 0;
  double at(double factor) const { return 0.5 * held + factor * (mixed + 0.5 * factor * scaled); }
};

class DamagedModel {
 public:
  /// Whole, but for bodies that `solve` lets drop. Throws what solve_statics() throws before it solves.
  DamagedModel(const Model& model, const FractureOptions& options, const StaticOptions& solve, int threads,
               FractureReport& report);

  /// Both motions. Throws AccuracyError.
  void solve();

  enum class Outcome {
    stands,
    cut_off,    ///< what the pattern acts on has lost its hold
    mechanism,  ///< what is left can move without energy
  };
  struct Removal {
    Outcome outcome = Outcome::stands;
    std::vector<std::vector<Index>> separated;  ///< bodies that hang on nothing from now on, by position
    bool load_lost = false;                     ///< one of them carried some of the loads that stay,
    Affine lost_work;                           ///< which had done this work
    std::string what;                           ///< all of it in words
  };
  /// Takes bonds out and solves for what is left. Where that does not stand they are put back, and all is as
  /// before.
  Removal take_out(const std::vector<BrokenBond>& bonds);

  /// Factorises what is left anew. After that, and after the same on what was carried to and fro, follow the
  /// same bits.
  void refresh();
  bool worth_refreshing() const { return !low_rank_ || low_rank_->rank() >= most_rank_; }

  const std::vector<BondProperties>& properties() const { return properties_; }
  const BondNetwork& network() const { return network_; }
  /// Neither gone nor between particles that are left out.
  bool stands(Index bond) const {
    return !gone_[std::size_t(bond)] && !left_out_[std::size_t(network_.links[std::size_t(bond)].a)];
  }
  const std::vector<CarriedParts>& carried() const { return carried_; }
  StrainEnergy energy() const { return energy_; }
  Affine load() const { return path_->load(incidence_, motions_[0], motions_[1]); }
  Affine displacement() const { return path_->displacement(motions_[0], motions_[1]); }
  Affine held_work() const { return path_->held_work(motions_[0], motions_[1]); }

  /// delta of one bond at a factor, and q = C delta of its link (nothing where it is gone).
  Vector6 motion_of(Index bond, double factor) const;
  Vector6 resultants_of(Index bond, double factor) const;

  /// The whole answer at a factor.
  State state(double factor) const;

  /// Content of a checkpoint; after reading it, refresh() and recover_parts() make the rest.
  void carry(Archive& archive);
  void recover_parts();

 private:
  void say(const std::string& phase) const;
  void refine(std::vector<double> came_by);
  std::vector<double> move_by(const Eigen::MatrixXd& steps);
  void leave_out(Index particle);
  BondNetwork standing() const;
  Removal drop_what_is_loose();
  void pin(const std::vector<Index>& body);

  FractureReport& report_;
  const Model& model_;
  StaticOptions solve_;
  int threads_;
  std::vector<BondProperties> properties_;  // of bonds that are gone: no stiffness
  BondNetwork network_;                     // likewise
  std::vector<double> normal_stiffness_;    // of all bonds, when whole
  Incidence incidence_;
  bool preloaded_ = false;
  Boundary held_, scaled_;
  std::unique_ptr<LoadPath> path_;
  FreeDofs dofs_;
  std::vector<bool> left_out_;  // particles
  std::vector<bool> gone_;      // bonds
  std::unique_ptr<LinearSolver> solver_;
  LowRankSolver* low_rank_ = nullptr;  // solver_, where it is direct
  bool analysed_ = false;              // for dofs_
  bool fresh_ = false;                 // the factor is of what is left, without changes
  double pivot_ratio_ = 1;
  Index most_rank_ = 0;
  std::vector<BodyVectors<Extended>> motions_;  // held, scaled; empty before the first solve
  Accuracy accuracy_;
  std::vector<CarriedParts> carried_;
  StrainEnergy energy_;
};

}  // namespace bondstatic
