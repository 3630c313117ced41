#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/mechanism.hpp"

namespace bondstatic {
namespace {

constexpr std::size_t most_ids = 8, most_mechanisms = 10, most_motions = 6;

// What is rounding beside `scale` prints as 0.
std::string text(const Vector3& v, double scale) {
  const auto clean = [&](double x) { return std::abs(x) < 1e-9 * scale ? 0.0 : x; };
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", clean(v[0]), clean(v[1]), clean(v[2]));
}

std::string ids(const Model& model, const std::vector<Index>& particles) {
  std::string list;
  for (std::size_t k = 0; k < std::min(particles.size(), most_ids); ++k)
    list += fmt::format("{}{}", k ? ", " : "", model.particles[std::size_t(particles[k])].id);
  if (particles.size() > most_ids) list += fmt::format(" ... ({} in all)", particles.size());
  return list;
}

std::string subject(const Model& model, const Mechanism& mechanism) {
  const std::string list = ids(model, mechanism.particles);
  if (mechanism.particles.size() == 1) return "particle " + list;
  return (mechanism.kind == Mechanism::Kind::internal ? "particles " : "body of particles ") + list;
}

std::string text(const FreeMotion& motion, double scale) {
  const std::string axis = text(motion.axis, 1);
  if (motion.translates) return "translate along " + axis;
  const std::string line = fmt::format("about the line through {} along {}", text(motion.point, scale), axis);
  if (motion.pitch == 0) return "rotate " + line;
  return fmt::format("screw {}, moving {:.6g} along it for each radian", line, motion.pitch);
}

std::string motions(const Model& model, const Mechanism& mechanism) {
  double scale = 0;
  for (const Index p : mechanism.particles)
    scale = std::max(scale, model.particles[std::size_t(p)].position.cwiseAbs().maxCoeff());
  std::string all;
  const std::size_t count = mechanism.motions.size();
  for (std::size_t k = 0; k < std::min(count, most_motions); ++k)
    all += (k ? ", to " : "") + text(mechanism.motions[k], scale);
  if (count > most_motions) all += fmt::format(" ... ({} independent motions in all)", count);
  return all;
}

std::string degrees_of_freedom(std::size_t count) {
  static const char* const words[] = {"no", "one", "two", "three", "four", "five", "six"};
  return fmt::format("{} more degree{} of freedom", count < 7 ? words[count] : fmt::format("{}", count),
                     count == 1 ? "" : "s");
}

// What moves, and how.
std::string finding(const Model& model, const Mechanism& mechanism) {
  const std::string who = subject(model, mechanism);
  const bool alone = mechanism.particles.size() == 1;
  switch (mechanism.kind) {
    case Mechanism::Kind::isolated:
      return who + " has neither bond nor support: free to translate and to rotate in all directions";
    case Mechanism::Kind::floating:
      return who + " is held by no support: free to translate and to rotate in all directions";
    case Mechanism::Kind::underconstrained:
      return fmt::format("{} is free to {}: its supports do not prevent it", who, motions(model, mechanism));
    case Mechanism::Kind::internal:
      break;
  }
  return fmt::format("{} {} free to {}: {} bonds do not prevent it", who, alone ? "is" : "are",
                     motions(model, mechanism), alone ? "its" : "their");
}

// The usual causes and what to do, for `count` free motions of one kind.
std::string cure(Mechanism::Kind kind, std::size_t count) {
  constexpr const char* drop = "or set unsupported = \"drop\" in [solve] to leave out unsupported bodies";
  switch (kind) {
    case Mechanism::Kind::isolated:
      return fmt::format("cure: bond it (is the bonding gap or contact radius too small?), support it, {}",
                         drop);
    case Mechanism::Kind::floating:
      return fmt::format("cure: support it, bond it to a body that is supported, {}", drop);
    case Mechanism::Kind::underconstrained:
      return fmt::format("cure: hold {} in [[supports]], in a direction that this motion has",
                         degrees_of_freedom(count));
    case Mechanism::Kind::internal:
      break;
  }
  return fmt::format(
      "cause: bonds that lack one of their four stiffnesses act as hinges: contact bonds carry no moment, "
      "edem-v2 feeds none back where torque_feedback is off, generic bonds may have zeros\n"
      "    cure: use a law with bending and twisting stiffness there, add bonds, or hold {} in [[supports]]",
      degrees_of_freedom(count));
}

// All findings of a kind share one cure.
std::string report(const Model& model, const std::vector<Mechanism>& mechanisms) {
  using Kind = Mechanism::Kind;
  std::string all = "the model is a mechanism, it can move without force:";
  for (const Kind kind : {Kind::isolated, Kind::floating, Kind::underconstrained, Kind::internal}) {
    std::size_t count = 0, free = 0;
    for (const Mechanism& mechanism : mechanisms) {
      if (mechanism.kind != kind) continue;
      free += mechanism.motions.size();
      if (++count <= most_mechanisms) all += "\n  " + finding(model, mechanism);
    }
    if (count > most_mechanisms)
      all += fmt::format("\n  ... and {} more like these", count - most_mechanisms);
    if (count > 0) all += "\n    " + cure(kind, free);
  }
  return all;
}

}  // namespace

std::string describe(const Model& model, const Mechanism& mechanism) {
  return finding(model, mechanism) + "\n    " + cure(mechanism.kind, mechanism.motions.size());
}

MechanismError::MechanismError(const Model& model, std::vector<Mechanism> mechanisms)
    : Error(ExitCode::mechanism, report(model, mechanisms)), mechanisms_(std::move(mechanisms)) {}

}  // namespace bondstatic
