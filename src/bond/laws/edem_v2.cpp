#include <fmt/format.h>

#include "bond/laws/formula.hpp"
#include "bond/laws/inputs.hpp"
#include "bond/laws/laws.hpp"
#include "bond/laws/round_section.hpp"
#include "bond/laws/scatter.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t {
  normal_stiffness,
  shear_stiffness,
  disk_scale,
  normal_range,
  shear_range,
  seed,
  torque_feedback
};

constexpr auto formula = []<class T>(const BondSite& site, std::span<const T> in) -> FormulaValue<T> {
  const RoundSection<T> section{in[disk_scale] * std::min(site.radius_a, site.radius_b)};
  const std::uint64_t key = pair_key(std::uint64_t(double(in[seed])), site.id_a, site.id_b);
  const T normal = in[normal_stiffness] + in[normal_range] * scatter(key, 0);
  const T shear = in[shear_stiffness] + in[shear_range] * scatter(key, 1);
  return {.kn = normal * section.area(),
          .ks = shear * section.area(),
          .kt = shear * section.polar_moment(),
          .kb = 0.5 * normal * section.polar_moment(),
          .radius = section.radius,
          .moments_fed_back = double(in[torque_feedback]) != 0};
};

std::string inconsistent(std::span<const double> in) {
  if (in[normal_range] >= in[normal_stiffness])
    return fmt::format("normal_range = {}: must be smaller than normal_stiffness = {}", in[normal_range],
                       in[normal_stiffness]);
  if (in[shear_range] >= in[shear_stiffness])
    return fmt::format("shear_range = {}: must be smaller than shear_stiffness = {}", in[shear_range],
                       in[shear_stiffness]);
  return {};
}

Parameter range_input(std::string name, std::string meaning) {
  Parameter input = required_input(std::move(name), dimension::stress_per_length, std::move(meaning), true);
  input.default_value = 0;
  return input;
}

std::vector<Parameter> inputs() {
  Parameter scale =
      required_input("disk_scale", dimension::none, "bonded disk scale: r over the smaller radius");
  scale.default_value = 1;
  Parameter first = required_input("seed", dimension::none, "seed of the scatter", true);
  first.default_value = 1;
  first.whole = true;
  first.upper = 9007199254740992;  // 2^53: beyond, a double skips whole numbers
  Parameter feedback = required_input("torque_feedback", dimension::none,
                                      "whether the bond's moments act on the particles", true);
  feedback.upper = 1;
  feedback.whole = feedback.truth = true;
  return {
      required_input("normal_stiffness", dimension::stress_per_length, "Sn: normal stiffness per unit area"),
      required_input("shear_stiffness", dimension::stress_per_length, "St: shear stiffness per unit area"),
      scale,
      range_input("normal_range", "Sn is drawn from normal_stiffness +- this"),
      range_input("shear_range", "St is drawn from shear_stiffness +- this"),
      first,
      feedback};
}

}  // namespace

BondLaw edem_v2_law() {
  return {
      .name = "edem-v2",
      .title = "EDEM Bonding V2",
      .source = "[EDEM-V2]",
      .formulas = {"r = disk_scale min(Ra, Rb)", "kn = Sn A", "ks = St A", "kt = St J", "kb = Sn J / 2",
                   "Sn, St uniform in stiffness +- range"},
      .parameters = inputs(),
      .contact_point = {ContactPoint::Kind::gap},
      .remark =
          "EDEM's page gives no contact point: the centre of the gap is assumed. torque_feedback has no "
          "default because the page has none and it decides the answer; off is read so: twisting and "
          "bending moments enter the stresses but do not act on the particles, the moment of the shear "
          "force about the centres does. The scatter depends on seed and particle ids alone; EDEM draws "
          "other numbers.",
      .evaluate = value_of(formula),
      .differentiate = derivative_of(formula),
      .inconsistent = inconsistent,
  };
}

}  // namespace bondstatic
