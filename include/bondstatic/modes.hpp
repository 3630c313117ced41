// Natural frequencies of a bond network with the masses of its bodies lumped at their centres: K x = w^2 M x
// over the free degrees of freedom, and the step that central differences may take. Frequencies are angular,
// in radians per unit of time. Every result has the same bits at any number of threads.
//
// Lanczos' method with implicit restarts (Sorensen, SIAM J. Matrix Anal. Appl. 13 (1992) 357, as in Spectra).
// All functions throw Error (invalid_input) where a free degree of freedom has no positive, finite mass.
#pragma once

#include <vector>

#include "bondstatic/linear_solver.hpp"
#include "bondstatic/network.hpp"

namespace bondstatic {

/// By body, numbered as in the network: mass for the three translations, inertia for the three rotations (the
/// same about any axis, as for spheres). Entries of bodies that are held altogether are not looked at.
struct BodyMasses {
  std::vector<double> mass;
  std::vector<double> inertia;
};

/// Of solid spheres; NaN where a particle has no density.
BodyMasses body_masses(const Model& model);

struct Mode {
  double frequency = 0;
  /// Motion of every body, zero where prescribed: x_i^T M x_j = 1 for i = j, else 0. The entry with the
  /// largest share of the kinetic energy is positive.
  std::vector<Vector6> shape;
};

/// The `count` lowest modes, ascending by frequency; all of them where there are fewer. `factorised` has
/// factorised this very network with these free dofs. Frequencies are Rayleigh quotients of the modes bond by
/// bond: they keep their digits where K is too badly conditioned for its eigenvalues to. Equal frequencies
/// come as often as they occur, with any orthogonal basis of their modes. Needs memory for 2 count + 20
/// vectors of unknowns. Throws AccuracyError where Lanczos does not converge.
std::vector<Mode> lowest_modes(const BondNetwork& network, const FreeDofs& dofs, const BodyMasses& masses,
                               LinearSolver& factorised, Index count);

/// Upper bound of all frequencies: the highest one to `tolerance`, relative. Where the spectrum is too dense
/// at its end for Lanczos to separate it (long uniform chains), larger by the residual of what was found.
/// Matrix-free; needs memory for about 30 vectors of unknowns. Zero where nothing is free or nothing resists;
/// links of bodies that are held still count.
double highest_frequency(const BondNetwork& network, const FreeDofs& dofs, const BodyMasses& masses,
                         int threads, double tolerance = 1e-10);

/// Largest stable time step of central differences (leapfrog): 2 / highest frequency without dashpots (null).
/// Dashpots that act with the velocity of the half step before shorten it: the largest dt with
///
///     lambda_max(M^-1 (2 dt D + dt^2 K)) <= 4,
///
/// for one mode of damping ratio zeta (2/w) (sqrt(1 + zeta^2) - zeta). D is the damping matrix of `dashpots`:
/// the same links as `stiffness`, with coefficients (force per velocity, moment per angular velocity,
/// coupling likewise) in the place of the stiffness. Never above the true limit by more than rounding, below
/// it by about 1e-10, relative. Infinite where nothing is free, or nothing resists.
double critical_time_step(const BondNetwork& stiffness, const BondNetwork* dashpots, const FreeDofs& dofs,
                          const BodyMasses& masses, int threads);

}  // namespace bondstatic
