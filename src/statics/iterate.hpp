// One load case on its way to the last digit. Its figures are those of all ranks, so that all of them judge
// alike.
#pragma once

#include "bondstatic/linear_solver.hpp"
#include "model/boundary.hpp"
#include "system/extended.hpp"
#include "system/natural_form.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

struct Iterate {
  BodyVectors<Extended> motion;
  double first_residual = 0, residual = 0;  ///< largest entry, of the start and of the latest round
  double force_contraction = 1;             ///< of the residual, by the latest round
  double correction = 0;                    ///< largest entry of the last one, rotations times the length
  double contraction = 1;                   ///< of corrections, by the latest round
  double earlier_contraction = 1;           ///< by the one before
  double expected = 0;                      ///< what the next correction would be
  double size = 0;                          ///< largest entry of the answer, likewise, or `least_size`
  /// What the strain of a periodic cell alone moves the ends of a bond apart, and the largest force that
  /// takes: the particles of a lattice do nothing beyond the strain, and rounding is judged by these.
  double least_size = 0, least_residual = 0;
  int steps = 0;
  int setbacks = 0;  ///< rounds in a row that did not contract
  bool begun_from_motion = false;
  bool done = false;

  /// At prescribed values.
  Iterate(const BondNetwork& network, const Boundary& boundary, int threads, Ranks* ranks);

  /// At `start` where motions are unknown. `came_by`: size of the correction that led there, 0 where it is
  /// not known; by how much the next one is smaller then tells how far it can be trusted.
  void begin_from(const BodyVectors<Extended>& start, const FreeDofs& dofs, double came_by);

  /// The right-hand side of the next correction; on several ranks, of own bodies.
  Eigen::VectorXd next_residual(const BondNetwork& network, const Boundary& boundary, const FreeDofs& dofs,
                                bool iterative, int threads, Ranks* ranks);

  /// Takes a correction.
  void add(const Eigen::VectorXd& step, const FreeDofs& dofs, double length, int threads, Ranks* ranks);

  /// Whether it is done, by a direct solver or an iterative one. Both throw AccuracyError where corrections
  /// do not contract. `enough`: of the answer, what the next correction would be at most.
  void judge_direct(double pivot_ratio, double enough);
  void judge_iterative(const SolveReport& last);

  /// Sets to zero what is rounding of the largest entry, or no larger than `noise`.
  void drop_negligible(const FreeDofs& dofs, double length, double noise);
};

}  // namespace bondstatic
