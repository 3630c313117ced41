#include "bond/codes/codes.hpp"

namespace bondstatic {

BondCode lammps_bpm_rotational() {
  const char* input = "bond_coeff TYPE";
  return {
      .name = "lammps-bpm-rotational",
      .title = "LAMMPS, bond_style bpm/rotational (package BPM)",
      .version = "4May2022 to 4Jul2026 (source)",
      .stored = {{"k_r", dimension::stiffness, "radial stiffness", std::string(input) + ", 1st number"},
                 {"k_s", dimension::stiffness, "shear stiffness", std::string(input) + ", 2nd number"},
                 {"k_t", dimension::rotational_stiffness, "twisting stiffness",
                  std::string(input) + ", 3rd number"},
                 {"k_b", dimension::rotational_stiffness, "bending stiffness",
                  std::string(input) + ", 4th number"}},
      .formulas = {"kn = k_r", "ks = k_s", "kt = k_t", "kb = k_b",
                   "normalize yes: kn = k_r / L, ks = k_s / L, kt and kb as given"},
      .contact_point = {ContactPoint::Kind::beam},
      .contact_point_text =
          "middle of the bond, a = L/2: the shear force puts r/2 times itself as a torque on "
          "either particle, whatever their radii",
      .known_from = "read from the source",
      .shear =
          "total: the angle between the bond and its reference direction, in the frame of one particle "
          "or (since 4Jul2026, the default) midway between both; no increments, no drift",
      .moments = "total twist and bending angles from the quaternions; both moments act on the particles",
      .here =
          "law = \"generic\", kn = k_r, ks = k_s, kt = k_t, kb = k_b (contact point at mid-length, as by "
          "default)",
      .fit = "all four as they are: one bond type for each set of numbers",
      .remarks = {"The reference state is that of the first run, not of the data file.",
                  "smooth yes (the default) weakens a bond by 1 - B^4, B the breaking criterion, before it "
                  "breaks: write smooth no for linear bonds.",
                  "Until 30Mar2026 the angles came from arc cosines in the frame of one particle, with noise "
                  "near rest: such runs stall instead of coming to rest.",
                  "Of the strengths that follow, the source reads twisting before bending in every version "
                  "looked at; "
                  "documentation before 4Jul2026 lists bending first.",
                  "Bonded particles also interact by pair forces where overlay/pair is yes."},
      .source = "docs.lammps.org/bond_bpm_rotational.html; lammps/lammps, src/BPM/bond_bpm_rotational.cpp",
      .realised =
          [](const BondSite&, std::span<const double> in) {
            return BondProperties{.stiffness = {.kn = in[0], .ks = in[1], .kt = in[2], .kb = in[3]}};
          },
      .stored_for =
          [](const BondSite&, const BondProperties& wanted) {
            const SectionStiffness& c = wanted.stiffness;
            return wanted.moments_fed_back ? std::vector{c.kn, c.ks, c.kt, c.kb}
                                           : std::vector{c.kn, c.ks, 0.0, 0.0};
          },
  };
}

}  // namespace bondstatic
