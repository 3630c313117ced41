#include "report/relaxed_case.hpp"

#include <algorithm>
#include <functional>

namespace bondstatic {

namespace {

/// A row for each quantity, a column for each load case.
class ByLoadCase {
 public:
  ByLoadCase(const std::string& title, const std::vector<JsonValue>& runs,
             const std::vector<std::string>& names, const std::string& note = "")
      : runs_(runs), table_{title, {"quantity"}, {}, note} {
    for (const std::string& name : names) table_.columns.push_back(name.empty() ? "value" : name);
  }

  ByLoadCase& row(const std::string& name, const std::function<PageField(const JsonValue&)>& value) {
    std::vector<PageField> fields{name};
    bool any = false;
    for (const JsonValue& run : runs_) {
      fields.push_back(value(run));
      any |= !std::holds_alternative<std::monostate>(fields.back());
    }
    if (any) table_.rows.push_back(std::move(fields));
    return *this;
  }
  ByLoadCase& number(const std::string& name, const char* key) {
    return row(name, [&](const JsonValue& run) { return field(run[key].number()); });
  }
  ByLoadCase& number(const std::string& name, const char* part, const char* key) {
    return row(name, [&](const JsonValue& run) { return field(run[part][key].number()); });
  }
  void put_into(std::vector<PageTable>& tables) {
    if (!table_.rows.empty()) tables.push_back(std::move(table_));
  }

 private:
  const std::vector<JsonValue>& runs_;
  PageTable table_;
};

}  // namespace

void put_relaxed_cases(PageRun& run, const std::vector<JsonValue>& runs,
                       const std::vector<std::string>& names, const PageUnits& units) {
  const std::string frequency = units.si ? ", rad/s" : ", rad per time";
  ByLoadCase(
      "Explicit run", runs, names,
      "The unbalanced force is over loads and reactions, the balance of energies over the largest of them.")
      .row("end", [](const JsonValue& one) { return field(one["end"].text()); })
      .number("steps", "steps")
      .number(units.in("time of the model", "s"), "time")
      .number("time on the clock, s", "seconds")
      .number(units.in("fastest particle", "m/s"), "fastest_particle")
      .number("unbalanced force", "unbalanced_force")
      .number(units.in("kinetic energy", "J"), "energies", "kinetic")
      .number(units.in("strain energy", "J"), "energies", "strain")
      .number(units.in("work", "J"), "energies", "work")
      .number(units.in("dissipated energy", "J"), "energies", "dissipated")
      .number("balance of energies", "energies", "balance")
      .put_into(run.tables);

  ByLoadCase plan("Time step and damping, from the model's frequencies", runs, names,
                  "They hold for a run of the same model by any explicit code with the same damping.");
  plan.number(units.in("critical time step", "s"), "plan", "critical_time_step")
      .number(units.in("time step", "s"), "plan", "time_step")
      .number("highest frequency" + frequency, "plan", "highest_frequency");
  std::size_t lowest = 0;
  for (const JsonValue& one : runs)
    lowest = std::max(lowest, one["plan"]["lowest_frequencies"].items().size());
  for (std::size_t i = 0; i < std::min<std::size_t>(lowest, 10); ++i)
    plan.row("frequency of mode " + std::to_string(i + 1) + frequency, [i](const JsonValue& one) {
      const std::vector<JsonValue> all = one["plan"]["lowest_frequencies"].items();
      return i < all.size() ? field(all[i].number()) : PageField();
    });
  plan.number(units.in("ramp of the loads", "s"), "plan", "ramp_time")
      .number(units.in("at rest for", "s"), "plan", "hold_time")
      .number("steps predicted", "plan", "predicted_steps")
      .number("particle damping that would be fastest", "plan", "best_particle_damping")
      .number("steps predicted with it", "plan", "best_predicted_steps")
      .put_into(run.tables);
}

}  // namespace bondstatic
