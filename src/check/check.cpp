#include "bondstatic/check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/network.hpp"
#include "check/differences.hpp"

namespace bondstatic {

namespace {

/// Runs under 1, 1/2, 1/4, 1/8 of the load take four orders apart.
constexpr int smallest_part = 8;

bool within(const std::vector<FieldDifference>& fields, double tolerance) {
  return std::all_of(fields.begin(), fields.end(),
                     [&](const FieldDifference& field) { return field.first_order <= tolerance; });
}

}  // namespace

bool Certificate::agrees() const {
  return !cases.empty() &&
         std::all_of(cases.begin(), cases.end(), [](const CaseCertificate& one) { return one.agrees; });
}

Certificate check(const Model& model, const StaticOptions& solve, const RelaxOptions& options,
                  const CheckProgress& progress) {
  Certificate certificate;
  certificate.kinematics = options.kinematics;
  certificate.tolerance = options.check_tolerance;

  // 1. The static answer.
  if (progress && !progress("static", nullptr)) return certificate;
  StaticSolution statics = solve_statics(model, solve);
  for (const Phase& phase : statics.report.phases) certificate.static_seconds += phase.seconds;

  // 2. The run under the full load, and under parts of it where orders are to be told apart.
  struct Run {
    double load_factor;
    std::string name;
    Relaxation relaxation;
  };
  std::vector<Run> runs;
  bool stopped = false;
  const auto run_at = [&](double load_factor, const std::string& name) {
    RelaxOptions at = options;
    at.load_factor = options.load_factor * load_factor;
    RelaxHooks hooks;
    if (progress) hooks.progress = [&](const RelaxProgress& how_far) { return progress(name, &how_far); };
    runs.push_back({load_factor, name, relax(model, at, solve, hooks)});
    stopped = runs.back().relaxation.interrupted;
    return !stopped;
  };

  const double length = bond_network(model, bond_properties(model)).rotation_length;
  const auto compare = [&] {
    certificate.cases.clear();
    for (std::size_t c = 0; c < statics.cases.size() && c < runs.front().relaxation.cases.size(); ++c) {
      std::vector<ScaledState> states;
      CaseCertificate one;
      one.at_rest = true;
      for (const Run& run : runs) {
        states.push_back({&run.relaxation.cases[c].state, run.load_factor});
        one.at_rest = one.at_rest && run.relaxation.cases[c].end == RunEnd::at_rest;
      }
      one.name = statics.cases[c].name;
      one.fields = differences(statics.cases[c], states, length);
      one.run = runs.front().relaxation.cases[c];
      one.statics = statics.cases[c].accuracy;
      one.agrees = one.at_rest && within(one.fields, certificate.tolerance);
      certificate.cases.push_back(std::move(one));
    }
  };

  // A run that is not at rest proves nothing, and further ones would not mend it.
  const auto all_at_rest = [&] {
    return std::all_of(runs.begin(), runs.end(), [](const Run& run) { return run.relaxation.at_rest(); });
  };

  // 3. Small kinematics agree or do not; finite ones agree at first order once higher ones are taken off,
  // more of them the larger the load is.
  bool go_on = run_at(1, "run");
  if (go_on && (options.kinematics == Kinematics::small || !all_at_rest())) compare();
  if (options.kinematics == Kinematics::finite)
    for (int part = 2; part <= smallest_part && go_on && all_at_rest() && !certificate.agrees(); part *= 2) {
      go_on = run_at(1.0 / part, fmt::format("run at 1/{} of the load", part));
      if (go_on) compare();
    }
  for (const RelaxedCase& one : runs.front().relaxation.cases) certificate.dynamic_seconds += one.seconds;
  certificate.warnings = runs.front().relaxation.warnings;
  certificate.statics = std::move(statics.report);
  if (stopped)
    for (CaseCertificate& one : certificate.cases) one.agrees = false;
  return certificate;
}

}  // namespace bondstatic
