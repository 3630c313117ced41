// The two halves of a solve with a supernodal factor of CHOLMOD, K = L L^T in the factor's order. CHOLMOD has
// them, too, but goes through all of L: of a few right-hand sides that touch two particles each, most of the
// forward half is zeros.
#pragma once

#include <cholmod.h>

#include <Eigen/Core>

namespace bondstatic {

/// x becomes L^-1 x; supernodes where x is zero in all columns are passed over.
void solve_lower(const cholmod_factor& factor, Eigen::MatrixXd& x);

/// x becomes L^-T x.
void solve_upper(const cholmod_factor& factor, Eigen::MatrixXd& x);

}  // namespace bondstatic
