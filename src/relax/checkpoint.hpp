// The load cases of a relaxation so far, and their checkpoint.
#pragma once

#include "relax/case_run.hpp"

namespace bondstatic {

/// Of all that a run depends on but max_steps, which may be raised between two parts of it.
std::uint64_t fingerprint_of(const Model& model, std::span<const BondProperties> properties,
                             const RelaxOptions& options, Unsupported unsupported, std::uint64_t probe);

class Progress {
 public:
  using MakeRun = std::function<CaseRun(Index load_case, const DynamicPlan& plan)>;

  Progress(std::uint64_t fingerprint, MakeRun make_run)
      : fingerprint_(fingerprint), make_run_(std::move(make_run)) {}

  /// The next load case.
  void start(const DynamicPlan& plan);

  std::size_t started() const { return runs_.size(); }
  CaseRun& run(std::size_t load_case) { return runs_[load_case]; }

  /// States that were kept, of each load case that was started.
  std::vector<std::vector<SavedState>> saved() const;

  std::string checkpoint();

  /// `name` is what messages call it. Throws Error (invalid_input) where it is damaged, or belongs to other
  /// data.
  void resume(const std::string& checkpoint, const std::string& name);

 private:
  std::uint64_t fingerprint_;
  MakeRun make_run_;
  std::vector<DynamicPlan> plans_;
  std::vector<CaseRun> runs_;
};

}  // namespace bondstatic
