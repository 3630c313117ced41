#include <cmath>

#include "bond/codes/codes.hpp"

namespace bondstatic {
namespace {

/// avoidGranularRatcheting multiplies the relative velocity by this, and leaves the levers at Ra and Rb.
double shear_factor(const BondSite& site) {
  return (site.radius_a + site.radius_b) / site.length;
}

}  // namespace

BondCode yade_cohfrict() {
  return {
      .name = "yade-cohfrict",
      .title = "YADE, Law2_ScGeom6D_CohFrictPhys_CohesionMoment",
      .version = "2023.02a (source, and probed by running it)",
      .stored = {{"kn", dimension::stiffness, "normal stiffness", "i.phys.kn"},
                 {"ks", dimension::stiffness, "shear stiffness", "i.phys.ks"},
                 {"ktw", dimension::rotational_stiffness, "twisting stiffness", "i.phys.ktw"},
                 {"kr", dimension::rotational_stiffness, "rolling (bending) stiffness", "i.phys.kr"}},
      .formulas =
          {"kn = kn", "ks = ks (Ra + Rb) / L", "kt = ktw", "kb = kr",
           "from CohFrictMat: kn = 2 Ea Ra Eb Rb / (Ea Ra + Eb Rb), E = young",
           "ks = 2 Ea Ra va Eb Rb vb / (Ea Ra va + Eb Rb vb), v = poisson (ks/kn, not a Poisson's ratio)",
           "kr = alphaKr Ra Rb ks, ktw = alphaKtw Ra Rb ks, harmonic means of the alphas"},
      .contact_point = {ContactPoint::Kind::gap},
      .contact_point_text = "centre of the gap or overlap (ScGeom.contactPoint), a = (L + Ra - Rb)/2",
      .known_from = "read from the source and probed",
      .shear =
          "incremental; with avoidGranularRatcheting (the default) the relative velocity of the centres "
          "is multiplied by (Ra + Rb)/L and the levers are Ra and Rb: shear is (Ra + Rb)/L as stiff, at "
          "a = L Ra/(Ra + Rb), while the force acts at the contact point",
      .moments =
          "act on the particles where momentRotationLaw is True in both materials; from the total "
          "relative rotation, or by increments with useIncrementalForm = True: the same at small "
          "rotations",
      .here = "law = \"generic\", kn, ks times (Ra + Rb)/L, kt = ktw, kb = kr, contact_point = \"gap\"",
      .fit = "all four as they are, ks times L/(Ra + Rb); set them on each interaction",
      .remarks = {"A bond with a gap pulls from the start unless i.phys.unp = i.geom.penetrationDepth.",
                  "Strengths and friction of CohFrictMat end linearity: make them large to compare.",
                  "With avoidGranularRatcheting = False, ks acts as it is, at the contact point."},
      .source =
          "YADE 2023.02a, pkg/dem/CohesiveFrictionalContactLaw.cpp, Ig2_Sphere_Sphere_ScGeom.cpp, "
          "ScGeom.cpp (getIncidentVel)",
      .realised =
          [](const BondSite& site, std::span<const double> in) {
            return BondProperties{
                .stiffness = {.kn = in[0], .ks = in[1] * shear_factor(site), .kt = in[2], .kb = in[3]}};
          },
      .stored_for =
          [](const BondSite& site, const BondProperties& wanted) {
            const SectionStiffness& c = wanted.stiffness;
            const double moments = wanted.moments_fed_back ? 1 : 0;
            return std::vector{c.kn, c.ks / shear_factor(site), moments * c.kt, moments * c.kb};
          },
      .departure =
          [](const BondSite& site) {
            const double sum = site.radius_a + site.radius_b;
            return std::abs(site.gap() * (site.radius_a - site.radius_b)) / (2 * sum * site.length);
          },
      .departure_text =
          "the point whose shear displacement counts and the point where the force acts are so "
          "far apart, over L; here both are at the centre of the gap",
  };
}

}  // namespace bondstatic
