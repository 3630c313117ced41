// One run: break by break, with what is controlled never falling.
#pragma once

#include <chrono>
#include <string>

#include "fracture/damaged_model.hpp"

namespace bondstatic {

class FractureRun {
 public:
  FractureRun(const Model& model, const FractureOptions& options, const StaticOptions& solve,
              const FractureHooks& hooks, int threads);
  Fracture run();

 private:
  /// P, d and the work of the loads that stay, at the same factor.
  struct Point {
    double load = 0;
    double displacement = 0;
    double held_work = 0;
  };

  bool step();
  bool passes_a_limit(const NextBreak& next);
  void start_event(const NextBreak& next);
  void break_bonds();
  void separate(const DamagedModel::Removal& removal);
  double factor_at_control(const Point& held) const;
  void measure();
  Point point(double factor) const;
  void move_to(const Point& to);
  void end(FractureEnd how, std::string reason);
  State state() const;  ///< now, named after the pattern
  void show(std::size_t events);
  bool wants_to_go_on();

  // checkpoints
  void take_snapshot();
  std::uint64_t fingerprint() const;
  void carry(Archive& archive);
  void resume();

  const Model& model_;
  FractureOptions options_;
  const FractureHooks& hooks_;
  int threads_;
  Fracture result_;
  DamagedModel damaged_;
  BondFailures failures_;

  Affine load_, displacement_, held_work_;
  double factor_ = 0;
  double largest_factor_ = 0;
  double largest_load_ = 0;
  double rest_displacement_ = 0;  // of the whole model under the preload alone
  double rest_energy_ = 0;
  double whole_stiffness_ = 0;  // of the pattern, when all was whole
  Point at_;                    // where work has been counted to
  double work_ = 0, dissipated_ = 0;
  Index breaks_ = 0, shown_ = 0;
  bool ended_ = false;
  std::uint64_t fingerprint_ = 0;  // before anything breaks
  std::string snapshot_;
  std::chrono::steady_clock::time_point kept_;
};

}  // namespace bondstatic
