// The model: particles, bonds, supports, loads. Plain data in one consistent unit system, global axes; it
// knows where a bond is and which law it follows, not what the law says.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

struct Particle {
  Index id = 0;
  Vector3 position = Vector3::Zero();
  double radius = 0;
  double density = not_given;
};

/// Of a solid sphere: 4/3 pi R^3 density, and 2/5 m R^2 about any axis; NaN where the density is not given.
double mass(const Particle& particle);
double moment_of_inertia(const Particle& particle);

/// Where along the branch vector a bond's force and moment act ([Chen2022] Eq. 1, 44 and section 4.3).
struct ContactPoint {
  enum class Kind {
    of_law,          ///< the law's own
    gap,             ///< centre of the gap: a = (L + Ra - Rb) / 2
    beam,            ///< middle of the branch: a = L / 2
    fraction,        ///< a = value * L, counted from the bond's particle a
    contact_radii,   ///< centre of the gap of contact radii: a = (L + value Ra - value Rb) / 2
    section_change,  ///< where two segments as long as the radii meet: a = L Ra / (Ra + Rb)
  };
  Kind kind = Kind::of_law;
  double value = 0;
};

/// How strong the bonds of one block are. `parameters` follow the order of the criterion's list, NaN stands
/// for "not given"; `overrides` as in BondBlock. Strengths scatter from bond to bond, each drawn on its own
/// or all of a bond `together`; a draw depends on the seed, the ids of the two particles and which bond
/// between them it is, not on any order, and is repeated until it is positive.
struct BondStrength {
  enum class Scatter {
    none,
    normal,   ///< about the given strength; `spread` is the coefficient of variation
    uniform,  ///< the given strength -+ `spread`, in its own unit
    weibull,  ///< the given strength is the scale (63 % are below); `spread` is the modulus
  };
  std::string criterion;
  std::vector<double> parameters;
  std::map<std::size_t, std::vector<double>> overrides = {};
  Scatter scatter = Scatter::none;
  std::vector<double> spread = {};  ///< of each parameter; 0: it does not scatter
  Index seed = 0;
  bool together = false;
};

/// What the bonds of one [[bonds]] block share. `parameters` follow the order of the law's parameter list;
/// NaN stands for "not given". `overrides` replace a parameter for single bonds (columns of a bond file):
/// overrides.at(p)[k] belongs to the k-th bond of the block, NaN where the file leaves it empty. `fractions`
/// likewise: the contact point of single bonds as a part of the branch from a; empty where no bond has its
/// own.
struct BondBlock {
  std::string law;
  std::vector<double> parameters;
  ContactPoint contact_point;
  std::map<std::size_t, std::vector<double>> overrides;
  std::vector<double> fractions = {};
  std::optional<BondStrength> strength = {};  ///< absent: they never break
};

/// A bond between two particles, given by their position in Model::particles.
struct Bond {
  Index id = 0;
  Index a = 0;
  Index b = 0;
  Vector3 branch = Vector3::Zero();  ///< x_b - x_a, plus the image shift in a periodic cell
  Index block = 0;                   ///< position in Model::blocks
  Index in_block = 0;                ///< this is the block's k-th bond
};

/// Load cases are numbered as in Model::load_cases; this stands for "all of them".
inline constexpr Index every_case = -1;

/// Prescribed motion of one particle; only the degrees of freedom with fixed[i] are prescribed.
struct Support {
  Index particle = 0;
  std::array<bool, 6> fixed{};
  Vector6 value = Vector6::Zero();
  Index load_case = every_case;
};

/// Force and moment on one particle; loads on one particle add up.
struct Load {
  Index particle = 0;
  Vector6 force = Vector6::Zero();
  Index load_case = every_case;
};

/// A cell that repeats itself: edge i is column i of `edges` (any three independent vectors: orthogonal or
/// triclinic), and the model goes on along those that are periodic. Bonds that leave the cell have the image
/// shift in their branch vector; particles may lie outside of it.
struct Cell {
  Vector3 origin = Vector3::Zero();
  Matrix3 edges = Matrix3::Identity();
  std::array<bool, 3> periodic{true, true, true};
};

/// Mean strain of a periodic cell (symmetric; shear components are those of the tensor, half the engineering
/// ones); strains of one load case add up. Displacements are then the strain's, from the cell's origin, and
/// what particles do beyond it; supports prescribe the latter alone.
struct Strain {
  Matrix3 value = Matrix3::Zero();
  Index load_case = every_case;
};

struct Model {
  std::vector<Particle> particles;
  std::vector<BondBlock> blocks;
  std::vector<Bond> bonds;
  std::vector<Support> supports;
  std::vector<Load> loads;
  std::vector<std::string> load_cases{""};  ///< one nameless case where the user names none
  std::optional<Cell> cell;
  std::vector<Strain> strains;  ///< only with a cell
};

}  // namespace bondstatic
