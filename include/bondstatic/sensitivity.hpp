// How a scalar of the static answer changes with the bonds, exactly, by the adjoint method.
//
// K is linear in each bond's stiffness numbers c = (kn, ks, kt, kb, coupling), and symmetric. A scalar J of
// the state changes, to first order, by sum_k a_k . dq_k + g . du + w . dr (resultants q = C delta,
// displacements u, reactions r). With the adjoint motion eta,
//
//     K eta = -g - B^T C a  where free,   eta = w where prescribed,
//
// which is one more right-hand side on the factor that is there,
//
//     dJ/dc_k = (B eta + a)_k . (dC/dc_k) delta_k
//
// (J. S. Arora & E. J. Haug, AIAA J. 17 (1979) 970), and a law's parameters follow by dc/dp, bond by bond.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

/// dJ/d(what BondResult says of one bond).
struct BondWeight {
  Index bond = 0;                   ///< position in Model::bonds
  Vector6 force = Vector6::Zero();  ///< dJ/d(BondResult::force), all six, global axes
  double energy = 0;                ///< dJ/d(BondResult::energy)
  double radius = 0;                ///< dJ/d(radius of the section), force held: of stresses
};

/// dJ/d(State) of one load case; what is not named does not count. Particles by their position in the model.
struct Functional {
  Index load_case = 0;
  std::vector<std::pair<Index, Vector6>> displacement;
  std::vector<std::pair<Index, Vector6>> reaction;  ///< free degrees of freedom have none
  std::vector<BondWeight> bonds;
  double energy = 0;                 ///< dJ/d(State::energy)
  Matrix3 stress = Matrix3::Zero();  ///< dJ/d(State::stress) of a periodic cell, component by component
};

/// A scalar of several load cases (a periodic cell's stiffness) has a functional for each.
using Functionals = std::vector<Functional>;

/// dJ/d(stiffness numbers) and dJ/d(radius of the section) of one bond; zero where it is left out.
struct BondGradient {
  SectionStiffness stiffness;
  double radius = 0;
};
using BondGradients = std::vector<BondGradient>;  ///< in the order of Model::bonds

/// One parameter of the law of one [[bonds]] block.
struct BlockParameter {
  Index block = 0;
  std::size_t parameter = 0;  ///< position in BondLaw::parameters
};

/// A static solve that can go on: again with other numbers on the same analysis of the pattern, and to
/// derivatives on the same factor. One process; the options are those of solve_statics().
class StaticAnalysis {
 public:
  /// The model lasts as long as this does; nothing is solved yet.
  StaticAnalysis(const Model& model, StaticOptions options);
  ~StaticAnalysis();
  StaticAnalysis(StaticAnalysis&&) noexcept;
  StaticAnalysis& operator=(StaticAnalysis&&) noexcept;

  /// The answer for the numbers that the model has now. Between calls law parameters, loads, strains and
  /// prescribed values may change; particles, bonds, which degrees of freedom are held, and load cases may
  /// not. Throws what solve_statics() throws; after that it may be called again.
  StaticSolution solve();

  /// Of each scalar, in the state of the last solve(), which must have ended well. All are solved together.
  std::vector<BondGradients> gradients(const std::vector<Functionals>& scalars);

  /// Of the last solve(), in the order of the bonds.
  const std::vector<BondProperties>& properties() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// dJ/dp where the parameter's value changes for all bonds that take it from their block.
double derivative(const BondGradients& gradient, const ParameterDerivative& parameter);

/// dJ/dp of each bond's own value, in the order of parameter.bonds.
std::vector<double> derivative_by_bond(const BondGradients& gradient, const ParameterDerivative& parameter);

}  // namespace bondstatic
