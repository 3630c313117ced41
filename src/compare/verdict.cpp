#include "compare/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bondstatic {

namespace {

/// A reason is named where it leaves less than this part of what was to be explained.
constexpr double explains = 0.1;
/// Reasons that leave less than so many times what the best one leaves cannot be told from it.
constexpr double as_good = 2;
/// A body swings with as much kinetic energy as the difference holds strain energy; one that creeps, damped
/// fifty times as much as critically, with a ten thousandth.
constexpr double swings = 1e-4;
/// Damping forces that a code counts among its net forces take some of what the bonds leave, not most of it.
constexpr double confirms = 0.3;
/// Of the acceleration: loads and bonds that are wrong put it into modes of all frequencies.
constexpr double slow = 0.5;

double difference_of(const Comparison& comparison, const char* field) {
  for (const FieldComparison& one : comparison.fields)
    if (one.field == field) return one.difference;
  return 0;
}

void conclude(Comparison& comparison, CompareVerdict verdict, std::string reason) {
  comparison.verdict = verdict;
  comparison.reason = std::move(reason);
}

/// Those that leave about as little as the best one; a factor on each stiffness always leaves least, and is
/// only named where nothing simpler does.
std::string named_suspects(const Comparison& comparison, double to_explain) {
  std::string text;
  double least = 0;
  const auto name = [&](const Suspect& suspect) {
    if (text.empty()) least = suspect.left;
    if (text.empty() || suspect.left <= as_good * least) text += (text.empty() ? "" : "; or ") + suspect.text;
  };
  for (const bool simple : {true, false}) {
    for (const Suspect& suspect : comparison.suspects)
      if ((suspect.what != "each stiffness") == simple && suspect.left <= explains * to_explain)
        name(suspect);
    if (!text.empty()) break;
  }
  return text;
}

}  // namespace

const char* name_of(CompareVerdict verdict) {
  switch (verdict) {
    case CompareVerdict::same_state:
      return "same state";
    case CompareVerdict::still_moving:
      return "still moving";
    case CompareVerdict::different_model:
      return "different model";
    case CompareVerdict::unexplained:
      break;
  }
  return "still moving, or a different model";
}

bool within_tolerance(const Comparison& c) {
  const bool near =
      difference_of(c, "displacement") <= c.tolerance && difference_of(c, "rotation") <= c.tolerance;
  // A swing of relative amplitude A passes the static answer with A^2 times its energy.
  const bool calm = !(std::sqrt(c.unbalance.kinetic) > c.tolerance);
  return near && calm;
}

double support_deviation(const Model& model, const State& statics, const Boundary& boundary,
                         const RunState& run) {
  double apart = 0, all = 0, held = 0, count = 0;
  for (std::size_t p = 0; p < model.particles.size(); ++p)
    for (int i = 0; i < 3; ++i) {
      const double u = statics.displacement[p][i], d = run.displacement[p][i] - u;
      if (!std::isfinite(d)) continue;
      all += u * u;
      ++count;
      if ((boundary.free[p] >> i) & 1) continue;
      apart += d * d;
      ++held;
    }
  return held > 0 && all > 0 ? std::sqrt(apart / held / (all / count)) : 0;
}

void judge(Comparison& c, const Evidence& evidence) {
  const double displacement = difference_of(c, "displacement"), rotation = difference_of(c, "rotation");
  const bool turns = std::any_of(c.fields.begin(), c.fields.end(),
                                 [](const FieldComparison& one) { return one.field == "rotation"; });
  const std::string figures = fmt::format("displacements differ by {:.2g}", displacement) +
                              (turns ? fmt::format(", rotations by {:.2g}", rotation) : "");
  if (within_tolerance(c))
    return conclude(c, CompareVerdict::same_state, fmt::format("{}, tolerance {:g}", figures, c.tolerance));

  // What the run says of itself comes first: a state on its way through tells nothing of the model.
  const Unbalance& u = c.unbalance;
  const double apart = std::max(displacement, c.tolerance);
  if (u.kinetic > swings * apart * apart)
    return conclude(
        c, CompareVerdict::still_moving,
        fmt::format("{}; kinetic energy is {:.2g} of the static strain energy, fastest particle {:.2g}",
                    figures, u.kinetic, u.fastest));
  if (u.moving_part > confirms)
    return conclude(
        c, CompareVerdict::still_moving,
        fmt::format("{}; the run's own net forces are {:.2g} of the residual that its state carries", figures,
                    u.moving_part));
  if (!std::isfinite(evidence.difference)) return conclude(c, CompareVerdict::unexplained, figures);

  // The case's own bonds, as they are: supports that moved otherwise, rotations that are not small.
  if (u.still_moves <= explains * evidence.difference) {
    if (evidence.supports > c.tolerance)
      return conclude(
          c, CompareVerdict::different_model,
          fmt::format("supported particles are elsewhere than the case holds them, by {:.2g} of the "
                      "displacements; with the run's places the difference is {:.2g}",
                      evidence.supports, u.still_moves));
    if (u.still_moves <= c.tolerance)
      return conclude(
          c, CompareVerdict::same_state,
          fmt::format("{}, all but {:.2g} of it by finite rotations, which a linear answer leaves out",
                      figures, u.still_moves));
  }
  const std::string named = named_suspects(c, u.still_moves);
  if (!named.empty())
    return conclude(c, CompareVerdict::different_model,
                    fmt::format("{}; the run looks like one with {}", figures, named));
  if (u.slow_modes > slow)
    return conclude(
        c, CompareVerdict::still_moving,
        fmt::format("{}; {:.0f} % of the acceleration that its state implies is in the slowest modes",
                    figures, 100 * u.slow_modes));
  conclude(
      c, CompareVerdict::unexplained,
      fmt::format("{}, {:.2g} of it beyond what finite rotations do; no stiffness, contact point or load "
                  "explains that",
                  figures, u.still_moves));
}

}  // namespace bondstatic
