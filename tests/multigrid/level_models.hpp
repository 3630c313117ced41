// A small network with everything that a level has to get right, and the natural form in a level's rows.
#pragma once

#include "multigrid/block_loop.hpp"
#include "multigrid/hierarchy.hpp"
#include "multigrid/packing.hpp"
#include "support/models.hpp"
#include "system/natural_form.hpp"

namespace bondstatic::test {

/// Disordered packing with coupled sections, contact points off the middle, ends in either order, held and
/// partly held particles; no unit is 1.
struct LevelProblem {
  BondNetwork network;
  Incidence incidence;
  FreeDofs dofs;
  std::mt19937_64 random{11};

  explicit LevelProblem(int edge) {
    const Model model = random_packing(random, edge, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
    network = bond_network(model, bond_properties(model));
    for (Link& link : network.links) {
      link.fraction = 0.2 + 0.6 * uniform();
      link.stiffness.coupling = 0.3 * std::sqrt(link.stiffness.ks * link.stiffness.kb);
      if (uniform() < 0.5) {
        std::swap(link.a, link.b);
        link.branch = -link.branch;
      }
    }
    incidence = link_incidence(network);
    std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
    for (int p = 0; p < edge; ++p) free[std::size_t(p)] = 0;
    for (int p = edge; p < 2 * edge; ++p) free[std::size_t(p)] = 0b110011;
    free.back() = 0b000111;
    dofs = number_free_dofs(std::move(free));
  }

  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random); }

  template <class Scalar>
  multigrid::Rows<Scalar> random_rows(Index rows) {
    auto result = multigrid::make_rows<Scalar>(rows);
    for (Index p = 0; p < rows; ++p)
      for (int i = 0; i < 6; ++i) result[std::size_t(p)].at[i] = Scalar(2 * uniform() - 1);
    return result;
  }

  /// K u in the units of the hierarchy, bond by bond; nothing is left out of the rows.
  template <class Scalar>
  multigrid::Rows<double> natural_product(const multigrid::Numbering& numbering,
                                          const multigrid::Units& units, const multigrid::Rows<Scalar>& u) {
    BodyVectors<double> motion(std::size_t(network.bodies), Vector6::Zero());
    for (std::size_t row = 0; row < numbering.body.size(); ++row)
      for (int i = 0; i < 6; ++i)
        motion[std::size_t(numbering.body[row])][i] = double(u[row].at[i]) / (i < 3 ? 1 : units.length);
    const auto q = link_resultants<double>(network, motion, 1);
    const auto force = gather_forces<double>(network, incidence, q, 1);
    auto result = multigrid::make_rows<double>(Index(numbering.body.size()));
    for (std::size_t row = 0; row < numbering.body.size(); ++row)
      for (int i = 0; i < 6; ++i)
        result[row].at[i] =
            force[std::size_t(numbering.body[row])][i] / (i < 3 ? 1 : units.length) / units.stiffness;
    return result;
  }
};

template <class Scalar>
multigrid::Rows<Scalar> product(const multigrid::Level<Scalar>& level, multigrid::Rows<Scalar> u) {
  auto result = multigrid::make_rows<Scalar>(level.bodies);
  multigrid::for_products(level, u, 1, [&](Index, Index first, Index last, const auto& y, auto&) {
    std::copy_n(y.begin(), last - first, result.begin() + first);
  });
  return result;
}

template <class A, class B>
double largest_difference(const multigrid::Rows<A>& a, const multigrid::Rows<B>& b, Index rows) {
  double apart = 0, size = 0;
  for (std::size_t p = 0; p < std::size_t(rows); ++p)
    for (int i = 0; i < 6; ++i) {
      apart = std::max(apart, std::abs(double(a[p].at[i]) - double(b[p].at[i])));
      size = std::max(size, std::abs(double(b[p].at[i])));
    }
  return apart / size;
}

}  // namespace bondstatic::test
