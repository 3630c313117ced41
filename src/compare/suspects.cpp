#include "compare/suspects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/least_squares.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

/// A part of the stiffness whose share of the motion is below this is not felt: nothing can be said of it.
constexpr double not_felt = 1e-6;

/// Motion as one vector over the unknowns, rotations times the length.
Eigen::VectorXd flat(const BodyVectors<double>& motion, const FreeDofs& dofs, double length) {
  Eigen::VectorXd values(dofs.unknowns());
  for_each_unknown(dofs, [&](std::size_t p, int i, Index unknown) {
    values[unknown] = motion[p][i] * (i < 3 ? 1 : length);
  });
  return values;
}

/// The same bonds held at the centre of the gap between spheres of `factor` times the radii.
BondNetwork at_gap_of(const Model& model, const BondNetwork& network, double factor) {
  BondNetwork moved = network;
  for (std::size_t k = 0; k < moved.links.size(); ++k) {
    const BondSite site = bond_site(model, model.bonds[k]);
    moved.links[k].fraction = 0.5 + factor * (site.radius_a - site.radius_b) / (2 * site.length);
  }
  return moved;
}

/// As bonds of two segments are held.
BondNetwork at_section_change(const Model& model, const BondNetwork& network) {
  BondNetwork moved = network;
  for (std::size_t k = 0; k < moved.links.size(); ++k) {
    const BondSite site = bond_site(model, model.bonds[k]);
    if (site.radius_a + site.radius_b > 0)
      moved.links[k].fraction = site.radius_a / (site.radius_a + site.radius_b);
  }
  return moved;
}

/// Forms K^-1 of what bonds ask for, over |u_static|.
class Scale {
 public:
  Scale(const BondNetwork& network, const Matrix3& strain, Response& response, const State& statics,
        const BodyVectors<double>& motion)
      : strain_(strain), response_(response), motion_(motion), length_(network.rotation_length) {
    size_ = vector(statics.displacement).stableNorm();
  }

  Eigen::VectorXd vector(const BodyVectors<double>& motion) const {
    return flat(motion, response_.dofs(), length_);
  }
  Eigen::VectorXd response(const BodyVectors<double>& forces) { return vector(response_.to(forces)) / size_; }
  Eigen::VectorXd bonds(const BondNetwork& network) {
    return response(sum_of(finite_forces(network, motion_, strain_)));
  }
  double size() const { return size_; }

 private:
  const Matrix3& strain_;
  Response& response_;
  const BodyVectors<double>& motion_;
  double length_, size_ = 0;
};

std::string times(const std::string& what, double factor) {
  return fmt::format("{} {:.4g} times the case's", what, factor);
}

/// One factor on one part of the stiffness, on all of it, and a factor on each part.
void suspect_stiffness(const Eigen::VectorXd& loads, const Eigen::MatrixXd& parts,
                       std::vector<Suspect>& out) {
  const Eigen::VectorXd all = parts.rowwise().sum();
  const bool loaded = loads.norm() > 0;
  std::vector<Eigen::Index> felt;
  for (Eigen::Index g = 0; g < parts.cols(); ++g) {
    if (parts.col(g).norm() <= not_felt * all.norm()) continue;
    felt.push_back(g);
    const Fit fit = fitted(loads - all + parts.col(g), parts.col(g));
    const std::string name = stiffness_part_names[g];
    if (fit.factors[0] > 0) out.push_back({name, times(name, fit.factors[0]), {fit.factors[0]}, fit.left});
  }
  if (!loaded || all.norm() == 0) return;
  const Fit one = fitted(loads, all);
  if (one.factors[0] > 0)
    out.push_back({"all stiffness or all loads",
                   fmt::format("all stiffness {:.4g} times, or all loads {:.4g} times the case's",
                               one.factors[0], 1 / one.factors[0]),
                   {one.factors[0]},
                   one.left});
  if (felt.size() < 2) return;
  const Fit each = fitted(loads, parts(Eigen::all, felt));
  if (each.factors.minCoeff() <= 0) return;
  std::string text;
  std::vector<double> factors(stiffness_parts, not_given);
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const auto g = std::size_t(felt[i]);
    factors[g] = each.factors[Eigen::Index(i)];
    text += fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", stiffness_part_names[g], factors[g]);
  }
  out.push_back({"each stiffness", text + " times the case's", factors, each.left});
}

std::string gap_text(double factor) {
  if (std::abs(factor) < 0.02) return "contact point at mid-length (\"beam\")";
  if (std::abs(factor - 1) < 0.02) return "contact point at the centre of the gap (\"gap\")";
  return fmt::format("contact point at the centre of the gap of {:.4g} times the radii (\"contact-radii\")",
                     factor);
}

/// r is quadratic in the place of the contact point: three places tell all.
void suspect_contact_point(const Model& model, const BondNetwork& network, const Eigen::VectorXd& loads,
                           const Eigen::VectorXd& own, Scale& scale, std::vector<Suspect>& out) {
  const bool coupled = std::any_of(network.links.begin(), network.links.end(),
                                   [](const Link& link) { return link.stiffness.coupling != 0; });
  if (coupled) return;  // its stiffness belongs to its contact point
  const Eigen::VectorXd beam = scale.bonds(at_gap_of(model, network, 0));
  const Eigen::VectorXd gap = scale.bonds(at_gap_of(model, network, 1));
  const Eigen::VectorXd far = scale.bonds(at_gap_of(model, network, 2));
  if ((gap - beam).norm() > not_felt * own.norm()) {
    const auto left_at = [&](double factor) {
      return (loads - 0.5 * (1 - factor) * (2 - factor) * beam - factor * (2 - factor) * gap -
              0.5 * factor * (factor - 1) * far)
          .norm();
    };
    const double factor = lowest_between(-0.5, 2, left_at);
    out.push_back({"contact point", gap_text(factor), {factor}, left_at(factor)});
    const Eigen::VectorXd change = scale.bonds(at_section_change(model, network));
    out.push_back({"contact point",
                   "contact point where segments as long as the radii meet (\"section-change\")",
                   {},
                   (loads - change).norm()});
  }
}

}  // namespace

Explained explain(const Model& model, const BondNetwork& network, const Boundary& boundary,
                  Response& response, const State& statics, const BodyVectors<double>& motion) {
  Scale scale(network, boundary.strain, response, statics, motion);
  Explained out;
  if (!(scale.size() > 0)) return out;
  const Eigen::VectorXd loads = scale.response(boundary.load);
  const PartForces forces = finite_forces(network, motion, boundary.strain);
  Eigen::MatrixXd parts(loads.size(), Eigen::Index(stiffness_parts));
  for (std::size_t g = 0; g < stiffness_parts; ++g) parts.col(Eigen::Index(g)) = scale.response(forces[g]);
  const Eigen::VectorXd own = parts.rowwise().sum();

  out.difference = (scale.vector(motion) - scale.vector(statics.displacement)).norm() / scale.size();
  out.left = (loads - own).norm();
  suspect_stiffness(loads, parts, out.suspects);
  suspect_contact_point(model, network, loads, own, scale, out.suspects);
  std::stable_sort(out.suspects.begin(), out.suspects.end(),
                   [](const Suspect& a, const Suspect& b) { return a.left < b.left; });
  return out;
}

}  // namespace bondstatic
