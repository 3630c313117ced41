// The static solve as something that can go on: with other numbers on the same analysis, to derivatives on
// the same factor.
#pragma once

#include <vector>

#include "bondstatic/sensitivity.hpp"
#include "solver/kept_factor.hpp"
#include "statics/choose.hpp"
#include "statics/held.hpp"
#include "statics/partners.hpp"
#include "statics/refine.hpp"
#include "statics/stopwatch.hpp"

namespace bondstatic {

class StaticRun {
 public:
  /// `partners`: null where the model is all of it. Both last as long as the run.
  StaticRun(const Model& model, const Partners* partners, const StaticOptions& options);

  /// `keep`: factors and motions stay for the next solve and for derivatives, and take memory.
  StaticSolution solve(bool keep);

  /// In the state of the last solve that kept.
  std::vector<BondGradients> gradients(const std::vector<Functionals>& scalars);

  const std::vector<BondProperties>& properties() const { return properties_; }

 private:
  // Load cases that hold the same degrees of freedom share one factorisation.
  struct Group {
    std::vector<std::size_t> cases;
    Held held;
    Chosen chosen;
    double pivot_ratio = 1;
    /// Of the first solve's cases; what the rounding of the natural form does hardly changes with the
    /// numbers.
    std::vector<double> rounding = {};
    KeptFactor* kept = nullptr;  ///< the chosen solver, where it is one
    /// Of the last derivatives, as many as are solved for at once: where the next ones begin.
    std::vector<BodyVectors<Extended>> adjoints = {};
  };

  static std::string reason_of(const Group& group);
  bool goes_on(const BondNetwork& network, const std::vector<Boundary>& boundaries) const;
  std::vector<Group> group_by_supports() const;
  void prepare(Group& group, bool keep, Stopwatch& timed) const;
  std::vector<Refined> factorise_and_refine(Group& group, const std::vector<const Boundary*>& loads,
                                            const std::vector<BodyVectors<Extended>>& start, Stopwatch& timed,
                                            StaticReport& report) const;
  std::vector<Refined> solved(Group& group, const std::vector<const Boundary*>& loads,
                              const std::vector<BodyVectors<Extended>>& start, Stopwatch& timed,
                              StaticReport& report) const;

  const Model& model_;
  const Partners* partners_;
  StaticOptions options_;
  Ranks* ranks_;
  int threads_ = 1;
  std::vector<BondProperties> properties_;
  BondNetwork network_;
  NetworkShare share_;
  Incidence incidence_;
  std::vector<Boundary> boundaries_;  ///< one a load case
  std::vector<Group> groups_;
  std::vector<BodyVectors<Extended>> motions_;  ///< likewise, of the last solve
  bool kept_ = false;                           ///< all of this belongs together, factors included
};

}  // namespace bondstatic
