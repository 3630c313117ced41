#include "formats/lammps/apply_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "formats/lammps/bond_coeffs.hpp"
#include "formats/packing_facts.hpp"

namespace bondstatic {
namespace {

/// Styles that move particles by their forces; "nve/bpm/sphere" is one by its beginning.
bool integrates(const std::string& style) {
  for (const char* begin : {"nve", "nvt", "nph", "npt"})
    if (style.starts_with(begin)) return true;
  return false;
}

/// Styles without a say in a state of rest: damping, output.
bool is_silent(const std::string& style) {
  for (const char* begin : {"damping/", "viscous", "ave/", "print", "store/", "halt", "dt/reset", "balance",
                            "momentum", "recenter", "vector", "property/atom"})
    if (style.starts_with(begin)) return true;
  return false;
}

class Application {
 public:
  Application(const LammpsScript& script, ForeignModel& model, std::vector<Fault>& faults)
      : script_(script),
        model_(model),
        faults_(faults),
        members_(script_group_members(script.groups, model, faults)) {
    for (std::size_t c = 0; c < script.bond_coefficients.size(); ++c) {
      const WholeRange& types = script.bond_coefficients[c].types;
      if (types.first == types.last)
        last_of_type_[types.first] = c;
      else
        of_several_types_.push_back(c);
    }
  }

  ForeignSetup run() {
    forget_doubts();
    take_cell();
    take_stiffness();
    for (const ScriptFix& fix : script_.fixes) take_fix(fix);
    hold_what_nothing_moves();
    if (script_.units == "si") model_.si = true;
    return std::move(setup_);
  }

 private:
  ImportNotes& notes() { return model_.notes; }

  /// What a data file leaves open the script says.
  void forget_doubts() {
    std::erase_if(notes().assumed, [](const std::string& note) {
      for (const char* doubt : {"normalize no", "periodic", "does not say its units"})
        if (note.find(doubt) != std::string::npos) return true;
      return false;
    });
  }

  void take_cell() {
    const auto& periodic = script_.periodic;
    if (periodic == std::array{false, false, false}) {
      model_.cell.reset();
      return;
    }
    if (!model_.cell) model_.cell = model_.box;
    if (model_.cell)
      model_.cell->periodic = periodic;
    else
      faults_.push_back({{script_.file, 0, 0},
                         "the script's boundary is periodic, but no file gives the box",
                         "give the data file, or a dump, which have it"});
  }

  /// The last bond_coeff that covers the type holds, as in LAMMPS.
  const ScriptBondCoefficients* coefficients_of(Index type) const {
    const auto& all = script_.bond_coefficients;
    const auto one = last_of_type_.find(type);
    const ScriptBondCoefficients* last = one == last_of_type_.end() ? nullptr : &all[one->second];
    for (auto c = of_several_types_.rbegin(); c != of_several_types_.rend(); ++c)
      if (last >= &all[*c])
        break;
      else if (all[*c].types.contains(type))
        return &all[*c];
    return last;
  }

  void take_stiffness() {
    if (!model_.bonds.empty() && !script_.bond_coefficients.empty()) take_coefficients();
    if (script_.normalize) normalize();
  }

  void take_coefficients() {
    std::map<Index, Index> bonds_without;  // by type
    Index taken = 0;
    std::array<std::vector<double>*, bpm_rotational_columns.size()> columns{};
    for (std::size_t k = 0; k < model_.bonds.size(); ++k) {
      const Index type = model_.bonds[k].type;
      const ScriptBondCoefficients* found = coefficients_of(type);
      // Bonds without a type: where there is one kind only, they are of it.
      if (!found && type < 0 && script_.bond_coefficients.size() == 1)
        found = &script_.bond_coefficients.front();
      if (!found) {
        ++bonds_without[type];
        continue;
      }
      if (taken++ == 0) columns = bpm_rotational_values(model_);
      for (std::size_t c = 0; c < columns.size(); ++c) (*columns[c])[k] = found->numbers[c];
    }
    if (taken > 0)
      notes().taken.push_back(
          fmt::format("Stiffness of {} of {} bonds by their types, from bond_coeff: kr ks kt kb "
                      "are kn ks kt kb, contact point at mid-length.",
                      taken, model_.bonds.size()));
    for (const auto& [type, count] : bonds_without)
      notes().left_out.push_back(fmt::format("bond_coeff says nothing of {} {}.",
                                             count == 1 ? "a bond" : fmt::format("{} bonds", count),
                                             type < 0 ? "without a type" : fmt::format("of type {}", type)));
  }

  void normalize() {
    const BondEnds ends(model_);
    for (const char* name : {"kn", "ks"}) {
      const auto found = model_.bond_columns.find(name);
      if (found == model_.bond_columns.end()) continue;
      for (std::size_t k = 0; k < found->second.size(); ++k) found->second[k] /= ends.branch(k).norm();
    }
  }

  /// Members of the fix's group; null where they cannot be told, or it has none.
  const std::vector<char>* members_of(const ScriptFix& fix) {
    const auto found = members_.find(fix.group());
    if (found == members_.end()) {
      faults_.push_back({fix.command.place(2), fmt::format("there is no group {}", fix.group()),
                         "make it with a group command above"});
      return nullptr;
    }
    if (!found->second) {
      left_out(fix, "its group cannot be told from the script");
      return nullptr;
    }
    const std::vector<char>& members = *found->second;
    if (std::find(members.begin(), members.end(), 1) == members.end()) {
      left_out(fix, "its group has no particle");
      return nullptr;
    }
    return &members;
  }

  void left_out(const ScriptFix& fix, const std::string& why) {
    notes().left_out.push_back(fmt::format("{} (line {}): {}.", fix.command.text(), fix.command.line, why));
  }

  void taken(const ScriptFix& fix, const std::vector<char>& members) {
    notes().taken.push_back(fmt::format("{} (line {}): of {} particles.", fix.command.text(),
                                        fix.command.line, std::count(members.begin(), members.end(), 1)));
  }

  void use_group(const std::string& name, const std::vector<char>& members) {
    if (name == "all") return;
    for (const ForeignGroup& group : setup_.groups)
      if (group.name == name) return;
    ForeignGroup made{name, {}};
    for (std::size_t p = 0; p < members.size(); ++p)
      if (members[p]) made.members.push_back(Index(p));
    setup_.groups.push_back(std::move(made));
  }

  void hold(const ScriptFix& fix, const std::array<bool, 6>& fixed, const std::vector<char>& members) {
    use_group(fix.group(), members);
    setup_.supports.push_back({fix.group(), fixed, fix.command.text()});
    taken(fix, members);
    held_.resize(members.size());
    for (std::size_t p = 0; p < members.size(); ++p)
      held_[p] |= members[p] && std::find(fixed.begin(), fixed.end(), false) == fixed.end();
  }

  void load(const ScriptFix& fix, const Vector3& value, bool gravity, const std::vector<char>& members) {
    use_group(fix.group(), members);
    setup_.loads.push_back({fix.group(), value, gravity, fix.command.text()});
    taken(fix, members);
  }

  /// Words [first, first + 3) of the fix as numbers.
  std::optional<Vector3> three_numbers(const ScriptFix& fix, std::size_t first, const std::string& usage) {
    if (fix.command.words.size() < first + 3) {
      faults_.push_back(
          {fix.command.place(), fmt::format("\"{}\" says too little", fix.command.text()), "write " + usage});
      return std::nullopt;
    }
    Vector3 value;
    bool sound = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto number = script_number(fix.command, first + i, script_.variables, faults_);
      sound &= number.has_value();
      value[Index(i)] = number.value_or(0);
    }
    return sound ? std::optional(value) : std::nullopt;
  }

  void take_setforce(const ScriptFix& fix, const std::vector<char>& members) {
    if (fix.command.words.size() < 7) {
      faults_.push_back({fix.command.place(), fmt::format("\"{}\" says too little", fix.command.text()),
                         "write fix ID GROUP setforce 0 0 0, NULL for a direction that stays free"});
      return;
    }
    std::array<bool, 6> fixed{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (fix.command.word(4 + i) == "NULL") continue;
      const auto number = script_number(fix.command, 4 + i, script_.variables, faults_);
      if (!number) return;
      if (*number != 0) return left_out(fix, "a force that replaces the bonds' has no state of rest");
      fixed[i] = true;
    }
    if (fix.command.words.size() > 7) return left_out(fix, "with region its particles cannot be told");
    hold(fix, fixed, members);
  }

  void take_gravity(const ScriptFix& fix, const std::vector<char>& members) {
    if (fix.command.words.size() < 6 || fix.command.word(5) != "vector")
      return left_out(fix, "only the style vector is read");
    const auto magnitude = script_number(fix.command, 4, script_.variables, faults_);
    const auto direction = three_numbers(fix, 6, "fix ID GROUP gravity 9.81 vector 0 0 -1");
    if (!magnitude || !direction) return;
    if (direction->isZero(0)) {
      faults_.push_back({fix.command.place(6), "gravity without a direction", "write e.g. vector 0 0 -1"});
      return;
    }
    load(fix, *magnitude * direction->normalized(), true, members);
  }

  void take_fix(const ScriptFix& fix) {
    const std::string& style = fix.style();
    if (is_silent(style)) return left_out(fix, "no part in a state of rest");
    if (!integrates(style) && style != "freeze" && style != "setforce" && style != "addforce" &&
        style != "gravity") {
      moves_otherwise_ |= style.starts_with("rigid") || style.starts_with("move") ||
                          style.starts_with("poems") || style.starts_with("langevin") ||
                          style.starts_with("brownian");
      return left_out(fix, "not read; its part in the state of rest is missing");
    }
    const std::vector<char>* members = members_of(fix);
    if (!members) {
      moves_otherwise_ |= integrates(style);
      return;
    }
    if (integrates(style)) {
      note_turning(fix);
      moved_.resize(members->size());
      for (std::size_t p = 0; p < members->size(); ++p) moved_[p] |= (*members)[p];
    } else if (style == "freeze") {
      hold(fix, {true, true, true, true, true, true}, *members);
    } else if (style == "setforce") {
      take_setforce(fix, *members);
    } else if (style == "gravity") {
      take_gravity(fix, *members);
    } else if (fix.command.words.size() > 7) {
      left_out(fix, "with its further keywords it is no constant force on each particle");
    } else if (const auto force = three_numbers(fix, 4, "fix ID GROUP addforce FX FY FZ")) {
      load(fix, *force, false, *members);
    }
  }

  /// Only nve/bpm/sphere turns the quaternions that bpm/rotational looks at (documentation, "Howto bpm").
  void note_turning(const ScriptFix& fix) {
    if (script_.bond_style != "bpm/rotational" || fix.style().starts_with("nve/bpm/sphere")) return;
    notes().assumed.push_back(
        fmt::format("{} (line {}): its particles are taken as free to turn, though of LAMMPS's fixes only "
                    "nve/bpm/sphere turns them.",
                    fix.command.text(), fix.command.line));
  }

  /// Particles that no fix integrates stay where they are. Where other fixes move particles, or nothing is
  /// integrated at all, this cannot be told.
  void hold_what_nothing_moves() {
    if (moved_.empty() || moves_otherwise_) return;
    held_.resize(moved_.size());
    ForeignGroup still{"not integrated", {}};
    for (std::size_t p = 0; p < moved_.size(); ++p)
      if (!moved_[p] && !held_[p]) still.members.push_back(Index(p));
    if (still.members.empty()) return;
    notes().assumed.push_back(
        fmt::format("{} particles are held because no fix nve... moves them.", still.members.size()));
    setup_.supports.push_back({still.name, {true, true, true, true, true, true}, "no fix nve... moves them"});
    setup_.groups.push_back(std::move(still));
  }

  const LammpsScript& script_;
  ForeignModel& model_;
  std::vector<Fault>& faults_;
  std::map<std::string, Members> members_;
  std::unordered_map<Index, std::size_t> last_of_type_;  ///< of bond_coeff of one type, in their list
  std::vector<std::size_t> of_several_types_;            ///< likewise, ascending
  ForeignSetup setup_;
  std::vector<char> moved_, held_;  ///< by integrating fixes; in all six degrees of freedom; empty: nobody
  bool moves_otherwise_ = false;
};

}  // namespace

std::optional<ForeignSetup> apply_script(const LammpsScript& script, ForeignModel& model,
                                         std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  ForeignSetup setup = Application(script, model, faults).run();
  ImportNotes& notes = model.notes;
  for (const auto& [from, to] : {std::pair(&script.notes.taken, &notes.taken),
                                 {&script.notes.assumed, &notes.assumed},
                                 {&script.notes.left_out, &notes.left_out}})
    to->insert(to->end(), from->begin(), from->end());
  if (faults.size() != before) return std::nullopt;
  return setup;
}

}  // namespace bondstatic
