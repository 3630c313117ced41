#include "app/relax_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/report.hpp"
#include "app/terminal.hpp"

namespace bondstatic {

namespace {

/// A time of the model: seconds are only known where the case is in SI.
std::string model_time(const Case& given, double time) {
  return fmt::format("{:.4g}{}", time, given.si ? " s" : "");
}

std::string steps_text(double steps) {
  return std::isfinite(steps) ? fmt::format("{:.0f} steps", steps) : "never";
}

std::vector<std::string> run_row(const Case& given, const RelaxedCase& run) {
  const char* how = run.end == RunEnd::at_rest ? "at rest after" : "not at rest after";
  return {"run", fmt::format("{} {} of {}, time {}, in {}", how, counted(run.steps, "step"),
                             model_time(given, run.plan.time_step), model_time(given, run.time),
                             seconds_text(run.seconds))};
}

std::vector<std::string> rest_row(const Case& given, const RelaxedCase& run) {
  return {"rest",
          fmt::format(
              "fastest particle {:.1e} (limit {:.0e}), unbalanced force {:.1e} of the loads (limit {:.0e}), "
              "for {}",
              run.unrest.fastest, given.relax.velocity_limit, run.unrest.unbalanced, given.relax.force_limit,
              model_time(given, run.plan.hold_time))};
}

std::vector<std::string> energy_row(const RelaxedCase& run) {
  const Energies& e = run.energies;
  return {"energies",
          fmt::format("strain {:.6g}, work {:.6g}, dissipated {:.6g}, kinetic {:.1e}; balance {:.1e}",
                      e.strain, e.work, e.dissipated, e.kinetic, e.balance())};
}

void add_advice(const Case& given, const RelaxedCase& run, TextTable& table) {
  const DynamicPlan& plan = run.plan;
  table.rows.push_back(
      {"time step", fmt::format("{} = {:.3g} of the critical {}, highest frequency {:.4g} rad per time",
                                model_time(given, plan.time_step), plan.time_step / plan.critical_time_step,
                                model_time(given, plan.critical_time_step), plan.highest)});
  if (plan.lowest.empty()) return;
  std::string lowest;
  for (const double w : plan.lowest) lowest += fmt::format("{}{:.4g}", lowest.empty() ? "" : ", ", w);
  table.rows.push_back({"slowest", lowest + " rad per time"});
  table.rows.push_back(
      {"damping",
       fmt::format("particle damping {:g}: predicted {}, took {}; {:.3g} would be fastest, predicted {}",
                   given.relax.particle_damping, steps_text(plan.predicted_steps),
                   steps_text(double(run.steps)), plan.best_particle_damping,
                   steps_text(plan.best_predicted_steps))});
}

std::string place_of(const Case& given, const Worst& worst) {
  if (worst.at < 0) return "";
  const auto at = std::size_t(worst.at);
  return worst.of_bond ? fmt::format("bond {}", given.model.bonds[at].id)
                       : fmt::format("particle {}", given.model.particles[at].id);
}

std::string share(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.1e}", value);
}

TextTable difference_table(const Case& given, const CaseCertificate& one, bool finite) {
  TextTable table{{{"relative difference", "largest", "norm"}}, {false, true, true, true, true, true}};
  const bool third = std::any_of(one.fields.begin(), one.fields.end(),
                                 [](const FieldDifference& field) { return !std::isnan(field.third_order); });
  if (finite) table.rows.front().insert(table.rows.front().end(), {"first order", "second order"});
  if (third) table.rows.front().push_back("third order");
  table.rows.front().push_back("largest at");
  table.right.resize(table.rows.front().size() - 1, true);
  for (const FieldDifference& field : one.fields) {
    std::vector<std::string> row{field.field, share(field.largest), share(field.norm)};
    if (finite) row.insert(row.end(), {share(field.first_order), share(field.second_order)});
    if (third) row.push_back(share(field.third_order));
    row.push_back(place_of(given, field.worst));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Where second and third order reach this part of the answer, the fifth may well reach a millionth.
constexpr double large_second_order = 0.02;

std::string verdict(const Case& given, const CaseCertificate& one, double tolerance) {
  if (one.agrees) return fmt::format("agree within {:g}", tolerance);
  if (one.run.end != RunEnd::at_rest) return "not at rest: " + unrest_text(given, one.run);
  if (!one.at_rest) return "not at rest under a part of the load\n    cure: raise max_steps in [dynamics]";
  std::string outside;
  for (const FieldDifference& field : one.fields)
    if (!(field.first_order <= tolerance)) outside += (outside.empty() ? "" : ", ") + field.field;
  const bool large = std::any_of(one.fields.begin(), one.fields.end(), [](const FieldDifference& field) {
    return field.second_order > large_second_order || field.third_order > large_second_order;
  });
  return fmt::format("DIFFER by more than {:g} in {}{}", tolerance, outside,
                     large
                         ? "; motions are so large that orders above the fourth are felt: compare under less "
                           "load, or with kinematics = \"small\""
                         : "");
}

}  // namespace

std::string progress_text(const RelaxProgress& progress) {
  std::string text = progress.load_case.empty() ? "" : progress.load_case + ": ";
  text += fmt::format("step {}, time {:.4g}, fastest particle {:.1e}, unbalanced force {:.1e}", progress.step,
                      progress.time, progress.unrest.fastest, progress.unrest.unbalanced);
  if (std::isfinite(progress.seconds_left))
    text += ", about " + seconds_text(progress.seconds_left) + " left";
  return text;
}

std::string unrest_text(const Case& given, const RelaxedCase& relaxed) {
  if (relaxed.end == RunEnd::at_rest) return "";
  const std::string name = relaxed.state.name.empty() ? "the run" : "load case " + relaxed.state.name;
  const Index at = relaxed.unrest.particle;
  return fmt::format(
      "{} is not at rest after {} steps: fastest particle {} at {:.2e} (limit {:g}), unbalanced force {:.2e} "
      "of the loads "
      "(limit {:g}); predicted were {}\n    cure: raise max_steps in [dynamics]{}",
      name, relaxed.steps, at < 0 ? Index(0) : given.model.particles[std::size_t(at)].id,
      relaxed.unrest.fastest, given.relax.velocity_limit, relaxed.unrest.unbalanced, given.relax.force_limit,
      steps_text(relaxed.plan.predicted_steps),
      given.relax.particle_damping > 0 || given.relax.bond_damping.any() ? ", or damp more"
                                                                         : ", and give it some damping");
}

std::string relaxation_report(const Case& given, const Relaxation& relaxation,
                              const std::vector<OutputValue>& outputs, const std::string& written) {
  std::vector<const State*> states;
  std::vector<LargestDisplacement> largest;
  for (const RelaxedCase& relaxed : relaxation.cases) {
    states.push_back(&relaxed.state);
    largest.push_back(largest_displacement(given.model, relaxed.state));
  }
  std::string text = heading(given, facts_of(given.model)) + "\n";
  // What is expected is the static answer, whose tolerance is not that of a run.
  text += given.outputs.empty() ? displacement_table(states, largest) : outputs_table(outputs, false);
  for (const RelaxedCase& relaxed : relaxation.cases) {
    text += relaxed.state.name.empty() ? "\n" : fmt::format("\n  {}\n", relaxed.state.name);
    TextTable table;
    table.rows = {run_row(given, relaxed), rest_row(given, relaxed), energy_row(relaxed)};
    add_advice(given, relaxed, table);
    text += to_text(table, 2);
  }
  TextTable last;
  if (!relaxation.dropped.empty()) last.rows.push_back({"left out", dropped_text(relaxation.dropped)});
  if (!written.empty()) last.rows.push_back({"written", written});
  if (!last.rows.empty()) text += "\n" + to_text(last, 2);
  return text + warnings_text(given.warnings) + warnings_text(relaxation.warnings);
}

std::string certificate_report(const Case& given, const Certificate& certificate) {
  const bool finite = certificate.kinematics == Kinematics::finite;
  std::string text = heading(given, facts_of(given.model));
  text += fmt::format("static answer and explicit run, {} kinematics\n", finite ? "finite" : "small");
  for (const CaseCertificate& one : certificate.cases) {
    text += one.name.empty() ? "\n" : fmt::format("\n  {}\n", one.name);
    text += to_text(difference_table(given, one, finite), 2) + "\n";
    TextTable table;
    table.rows = {
        {"verdict", bold(verdict(given, one, certificate.tolerance), stdout)},
        {"static",
         fmt::format("relative error at most {:.1e}, backward error {:.1e}, energy and work {:.1e}",
                     one.statics.forward_error, one.statics.backward_error, one.statics.energy_balance)},
        run_row(given, one.run),
        rest_row(given, one.run),
        energy_row(one.run)};
    add_advice(given, one.run, table);
    text += to_text(table, 2);
  }
  text += fmt::format("\n  static {}, run {}: {:.3g} times as long\n",
                      seconds_text(certificate.static_seconds), seconds_text(certificate.dynamic_seconds),
                      certificate.dynamic_seconds / certificate.static_seconds);
  return text + warnings_text(given.warnings) + warnings_text(certificate.warnings);
}

}  // namespace bondstatic
