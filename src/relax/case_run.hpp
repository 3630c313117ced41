// One load case on its way to rest: runs a stretch of steps, looks, records, and decides whether to go on.
#pragma once

#include "bondstatic/relaxation.hpp"
#include "relax/history.hpp"
#include "relax/saved_states.hpp"

namespace bondstatic {

class Archive;

class CaseRun {
 public:
  CaseRun(const Model& model, std::span<const BondProperties> properties, Index load_case,
          const std::vector<bool>& left_out, const DynamicPlan& plan, const RelaxOptions& options,
          int threads);

  /// Runs to the next look. False where the run has ended. Throws AccuracyError where it blows up.
  bool go_on(const RelaxHooks& hooks);

  bool ended() const { return ended_; }
  Index step() const { return run_.step(); }
  double time() const { return run_.time(); }
  const Unrest& unrest() const { return unrest_; }
  double seconds_left() const;
  const SavedStates& saved() const { return saved_; }

  RelaxedCase result() const;
  void carry(Archive& archive);  ///< everything that changes, out or in

 private:
  void look(const RelaxHooks& hooks);
  void record(const RelaxHooks& hooks, const Energies& energies);
  void save(const RelaxHooks& hooks);
  bool on_grid() const { return run_.step() % stretch_ == 0; }
  void check_for_blow_up(const Energies& energies);

  DynamicPlan plan_;
  RelaxOptions options_;
  ExplicitRun run_;
  Index stretch_;  ///< steps between two looks
  Index hold_steps_;
  Index calm_since_ = -1;  ///< step since which every look was calm; -1: not calm
  bool ended_ = false, at_rest_ = false;
  double most_work_ = 0;
  Unrest unrest_;
  History history_;
  std::vector<double> last_row_;  ///< where the run ended, unless the history has it
  SavedStates saved_;
  double seconds_ = 0;
  double seconds_a_step_ = 0;
};

}  // namespace bondstatic
