#include "support/quad_reference.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "bondstatic/bond_law.hpp"

namespace bondstatic::test {

namespace {

__extension__ using Quad = __float128;
using Quad3 = std::array<Quad, 3>;
using Row = std::array<Quad, 12>;

Quad square_root(Quad value) {
  Quad root = std::sqrt(static_cast<long double>(value));
  for (int i = 0; i < 2; ++i) root = (root + value / root) / 2;
  return root;
}

Quad3 cross(const Quad3& a, const Quad3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Quad3 unit(Quad3 v, Quad& length) {
  length = square_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (Quad& x : v) x /= length;
  return v;
}

// Rows of B times the rotation to the bond's axes: the six relative motions from the twelve global ones.
std::array<Row, 6> relative_motion_rows(const Bond& bond, double fraction) {
  Quad length, ignored;
  const Quad3 ex = unit({bond.branch.x(), bond.branch.y(), bond.branch.z()}, length);
  const Quad3 helper = std::abs(bond.branch.x()) > 0.7 * bond.branch.norm() ? Quad3{0, 1, 0} : Quad3{1, 0, 0};
  const Quad3 ez = unit(cross(ex, helper), ignored), ey = cross(ez, ex);
  const Quad a = length * Quad(fraction), b = length - a;
  std::array<Row, 6> rows{};
  for (std::size_t i = 0; i < 3; ++i) {
    // dx = ubx - uax,  dy = uby - uay - a taz - b tbz,  dz = ubz - uaz + a tay + b tby, and tb - ta
    const auto put = [&rows, i](std::size_t row, std::size_t block, Quad value) {
      rows[row][3 * block + i] += value;
    };
    put(0, 0, -ex[i]), put(0, 2, ex[i]);
    put(1, 0, -ey[i]), put(1, 2, ey[i]), put(1, 1, -a * ez[i]), put(1, 3, -b * ez[i]);
    put(2, 0, -ez[i]), put(2, 2, ez[i]), put(2, 1, a * ey[i]), put(2, 3, b * ey[i]);
    put(3, 1, -ex[i]), put(3, 3, ex[i]);
    put(4, 1, -ey[i]), put(4, 3, ey[i]);
    put(5, 1, -ez[i]), put(5, 3, ez[i]);
  }
  return rows;
}

std::array<std::array<Quad, 6>, 6> section(const SectionStiffness& s) {
  std::array<std::array<Quad, 6>, 6> c{};
  const double diagonal[6] = {s.kn, s.ks, s.ks, s.kt, s.kb, s.kb};
  for (std::size_t i = 0; i < 6; ++i) c[i][i] = diagonal[i];
  c[1][5] = c[5][1] = s.coupling;
  c[2][4] = c[4][2] = -s.coupling;
  return c;
}

// K x = f by L D L^T without pivoting: K is positive definite.
std::vector<Quad> solve(std::vector<std::vector<Quad>> k, std::vector<Quad> f) {
  const std::size_t n = f.size();
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j + 1; i < n; ++i) {
      if (k[i][j] == 0) continue;
      const Quad factor = k[i][j] / k[j][j];
      for (std::size_t c = j; c < n; ++c) k[i][c] -= factor * k[j][c];
      f[i] -= factor * f[j];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t c = i + 1; c < n; ++c) f[i] -= k[i][c] * f[c];
    f[i] /= k[i][i];
  }
  return f;
}

}  // namespace

std::vector<Vector6T<long double>> quad_displacement(const Model& model, Index load_case) {
  const std::size_t count = model.particles.size(), dofs = 6 * count;
  std::vector<std::vector<Quad>> k(dofs, std::vector<Quad>(dofs, 0));
  std::vector<Quad> f(dofs, 0), u(dofs, 0);
  std::vector<bool> fixed(dofs, false);
  const auto properties = bond_properties(model);
  for (std::size_t e = 0; e < model.bonds.size(); ++e) {
    const Bond& bond = model.bonds[e];
    const auto rows = relative_motion_rows(bond, properties[e].fraction);
    const auto c = section(properties[e].stiffness);
    const auto dof = [&bond](std::size_t i) { return std::size_t(6 * (i < 6 ? bond.a : bond.b)) + i % 6; };
    for (std::size_t i = 0; i < 12; ++i)
      for (std::size_t j = 0; j < 12; ++j)
        for (std::size_t p = 0; p < 6; ++p)
          for (std::size_t q = 0; q < 6; ++q) k[dof(i)][dof(j)] += rows[p][i] * c[p][q] * rows[q][j];
  }
  const auto concerns = [load_case](Index named) { return named == every_case || named == load_case; };
  for (const Support& support : model.supports)
    for (std::size_t i = 0; concerns(support.load_case) && i < 6; ++i)
      if (support.fixed[i]) {
        fixed[std::size_t(6 * support.particle) + i] = true;
        u[std::size_t(6 * support.particle) + i] = support.value[Index(i)];
      }
  for (const Load& load : model.loads)
    for (std::size_t i = 0; concerns(load.load_case) && i < 6; ++i)
      f[std::size_t(6 * load.particle) + i] += load.force[Index(i)];

  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < dofs; ++i)
    if (!fixed[i]) free.push_back(i);
  std::vector<std::vector<Quad>> reduced(free.size(), std::vector<Quad>(free.size()));
  std::vector<Quad> right(free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    right[i] = f[free[i]];
    for (std::size_t j = 0; j < dofs; ++j)
      if (fixed[j]) right[i] -= k[free[i]][j] * u[j];
    for (std::size_t j = 0; j < free.size(); ++j) reduced[i][j] = k[free[i]][free[j]];
  }
  const auto x = solve(std::move(reduced), std::move(right));
  for (std::size_t i = 0; i < free.size(); ++i) u[free[i]] = x[i];
  std::vector<Vector6T<long double>> displacement(count);
  for (std::size_t i = 0; i < dofs; ++i) displacement[i / 6][Index(i % 6)] = static_cast<long double>(u[i]);
  return displacement;
}

}  // namespace bondstatic::test
