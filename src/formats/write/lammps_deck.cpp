// Commands as in LAMMPS' documentation (docs.lammps.org): bond_bpm_rotational, fix_nve_bpm_sphere,
// fix_damping_cundall, fix_freeze, fix_setforce, fix_settorque_atom, fix_addforce, fix_addtorque_atom, set,
// variable (atomfile), dump, compute_bond_local.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "formats/write/lammps_files.hpp"

namespace bondstatic {

namespace {

constexpr std::size_t comment_width = 100;
constexpr Index thermo_lines = 50;

using RoleTest = std::function<bool(const LammpsRole&)>;

/// A text that LAMMPS' input parser leaves alone: it joins lines at & and over three double quotes even in
/// comments.
std::string harmless(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '&' || c == '"' || c == '\n'; }, ' ');
  return text;
}

std::string comment(const std::string& text) {
  std::string out, line = "#";
  const std::string words = harmless(text) + ' ';
  for (std::size_t begin = 0, end; (end = words.find(' ', begin)) != std::string::npos; begin = end + 1) {
    const std::string word = words.substr(begin, end - begin);
    if (line.size() + word.size() > comment_width) {
      out += line + '\n';
      line = "#  ";
    }
    line += ' ' + word;
  }
  return out + line + '\n';
}

std::string vector_text(const Vector3& v) {
  return fmt::format("{} {} {}", v[0], v[1], v[2]);
}

class Deck {
 public:
  Deck(const LammpsModel& model, std::vector<LammpsVariable>& variables)
      : model_(model), variables_(variables) {}

  std::string text(const ExportNotes& notes) {
    heading(notes);
    model();
    bonds();
    particles();
    loads();
    supports();
    run();
    return text_;
  }

 private:
  template <class... T>
  void say(fmt::format_string<T...> format, T&&... values) {
    text_ += fmt::format(format, std::forward<T>(values)...) + '\n';
  }

  bool any(const RoleTest& test) const {
    return std::any_of(model_.roles.roles.begin(), model_.roles.roles.end(), test);
  }
  /// The group of all types whose roles pass; none where no role does.
  bool group(const std::string& name, const RoleTest& test) {
    std::string types;
    for (std::size_t t = 0; t < model_.roles.roles.size(); ++t)
      if (test(model_.roles.roles[t])) types += fmt::format(" {}", t + 1);
    if (!types.empty()) say("group        {} type{}", name, types);
    return !types.empty();
  }

  /// A number a particle in a file of its own; particles that are not listed have zero.
  void variable(const std::string& name, const std::function<double(std::size_t)>& value) {
    LammpsVariable numbers{name, {}, {}};
    for (std::size_t p = 0; p < model_.input.model.particles.size(); ++p)
      if (const double number = value(p); number != 0) {
        numbers.particles.push_back(p);
        numbers.values.push_back(number);
      }
    if (numbers.particles.empty()) {  // a file must hold a number at least
      numbers.particles.push_back(0);
      numbers.values.push_back(0);
    }
    say("variable     {0} atomfile {0}.txt", name);
    variables_.push_back(std::move(numbers));
  }

  void heading(const ExportNotes& notes) {
    text_ += comment(model_.input.title.empty() ? "A bonded model" : model_.input.title);
    text_ += comment("Written by bondstatic. Run with: lmp -in " + std::string(lammps_deck_file) +
                     " (packages BPM, GRANULAR, MOLECULE; LAMMPS of March 2023 or newer" +
                     (needs_atom_torques() ? ", of December 2025 or newer for the fixes .../atom)" : ")"));
    if (const State* state = model_.input.state) {
      double largest = 0;
      std::size_t where = 0;
      for (std::size_t p = 0; p < state->displacement.size(); ++p)
        if (const double u = relaxed_motion(model_.input, p).head<3>().norm(); u > largest) {
          largest = u;
          where = p;
        }
      text_ +=
          comment(fmt::format("Static answer of bondstatic: largest displacement {:.9g}, of particle {}.",
                              largest, model_.id(where)));
    }
    for (const std::string& note : notes.not_expressed) text_ += comment("ANOTHER MODEL: " + note);
    for (const std::string& note : notes.remarks) text_ += comment("Note: " + note);
    text_ += '\n';
  }

  void model() {
    const double skin = 0.3 * model_.bonds.shortest;
    text_ += comment("numbers are in one consistent system of units, as in units si");
    say("units        si");
    say("atom_style   bpm/sphere");
    say("boundary     {}", model_.box.boundary());
    say("newton       on off");
    say("comm_modify  vel yes cutoff {:.6g}", 2 * model_.bonds.longest + skin);
    if (model_.box.large_tilt()) say("box          tilt large");
    say("special_bonds lj 0.0 1.0 1.0 coul 0.0 1.0 1.0");
    say("read_data    {} nocoeff", lammps_data_file);
    say("pair_style   zero {:.6g}", model_.bonds.longest);
    say("pair_coeff   * *");
    say("neighbor     {:.6g} bin", skin);
    say("neigh_modify every 1 delay 0 check yes");
  }

  void bonds() {
    text_ += '\n' + comment(
                        "k_r k_s k_t k_b, strengths that no bond reaches, no damping in the bonds; "
                        "stiffnesses as such (normalize is off by default)");
    say("bond_style   bpm/rotational break no smooth no");
    const auto& types = model_.bonds.types;
    if (types.size() > lammps_types_in_deck) {
      say("include      {}", lammps_coefficient_file);
      return;
    }
    for (std::size_t t = 0; t < types.size(); ++t)
      say("bond_coeff   {} {}", t + 1, lammps_coefficients(types[t]));
  }

  void particles() {
    text_ += '\n' + comment("atom types:");
    for (std::size_t t = 0; t < model_.roles.roles.size(); ++t)
      text_ += comment(fmt::format("  {}: {} ({} particles)", t + 1, model_.roles.roles[t].text(),
                                   model_.roles.roles[t].particles));
    if (group("held", [](const LammpsRole& role) { return role.held_altogether(); }))
      say("group        mobile subtract all held");
    else
      say("group        mobile union all");
    if (group("spinning",
              [](const LammpsRole& role) { return !role.held_altogether() && !role.holds_all_rotations(); }))
      say("fix          move_spinning spinning nve/bpm/sphere");
    if (group("gliding",
              [](const LammpsRole& role) { return !role.held_altogether() && role.holds_all_rotations(); })) {
      text_ += comment("rotations held: fix nve moves centres only");
      say("fix          move_gliding gliding nve");
    }
  }

  void loads() {
    const LammpsRoles& roles = model_.roles;
    if (!any([](const LammpsRole& role) { return role.loaded; })) return;
    text_ += '\n' + comment("loads, on each particle of a group");
    if (roles.loads_by_particle) {
      group("loaded", [](const LammpsRole& role) { return role.loaded; });
      const auto component = [&](int i) { return [&roles, i](std::size_t p) { return roles.load[p][i]; }; };
      const auto has = [&](int first) {
        return std::any_of(roles.load.begin(), roles.load.end(), [first](const Vector6& load) {
          return load.segment<3>(first) != Vector3(Vector3::Zero());
        });
      };
      if (has(0)) {
        for (const int i : {0, 1, 2}) variable(std::string("load_f") + "xyz"[i], component(i));
        say("fix          force loaded addforce v_load_fx v_load_fy v_load_fz");
      }
      if (has(3)) {
        for (const int i : {0, 1, 2}) variable(std::string("load_m") + "xyz"[i], component(3 + i));
        say("fix          moment loaded addtorque/atom v_load_mx v_load_my v_load_mz");
      }
      return;
    }
    std::map<std::vector<double>, std::string> groups;  // roles with one load and other supports share it
    for (const LammpsRole& role : roles.roles) {
      if (!role.loaded) continue;
      const std::vector<double> load(role.load.begin(), role.load.end());
      const std::string number = std::to_string(groups.size() + 1);
      if (!groups.try_emplace(load, number).second) continue;
      group("loaded_" + number,
            [&](const LammpsRole& other) { return other.loaded && other.load == role.load; });
      const Vector3 force = role.load.head<3>(), moment = role.load.tail<3>();
      if (force != Vector3(Vector3::Zero()))
        say("fix          force_{0} loaded_{0} addforce {1}", number, vector_text(force));
      if (moment != Vector3(Vector3::Zero()))
        say("fix          moment_{0} loaded_{0} addtorque/atom {1}", number, vector_text(moment));
    }
  }

  /// Of the supports that hold some of three degrees of freedom from `first`: a group and a fix each.
  void hold_some(int first, const std::string& prefix, const std::string& fix) {
    for (int mask = 1; mask < 8; ++mask) {
      const auto holds = [&](const LammpsRole& role) {
        return !role.held_altogether() && ((role.held >> first) & 7) == mask &&
               (first == 0 || !role.holds_all_rotations());
      };
      std::string name = prefix, values;
      for (int i = 0; i < 3; ++i) {
        const bool held = (mask >> i) & 1;
        if (held) name += "xyz"[i];
        values += held ? " 0.0" : " NULL";
      }
      if (group(name, holds)) say("fix          {0} {0} {1}{2}", name, fix, values);
    }
  }

  /// After loads and damping, so that nothing is added to what a support takes.
  void supports() {
    text_ += '\n' + comment("damping, then supports");
    say("fix          damping mobile damping/cundall {0} {0}", model_.input.particle_damping);
    hold_some(0, "hold_", "setforce");
    hold_some(3, "hold_r", "settorque/atom");
    if (any([](const LammpsRole& role) { return role.held_altogether(); }))
      say("fix          held held freeze");
  }

  /// Where particles stand after the bonds have taken their reference state: the prescribed motions of
  /// supports, or the whole static answer.
  Vector6 start(std::size_t p) const {
    return model_.input.relaxed ? relaxed_motion(model_.input, p) : model_.roles.prescribed[p];
  }

  void begin_elsewhere() {
    const std::size_t count = model_.input.model.particles.size();
    bool moved = false, turned = false;
    for (std::size_t p = 0; p < count; ++p) {
      moved = moved || start(p).head<3>() != Vector3(Vector3::Zero());
      turned = turned || start(p).tail<3>() != Vector3(Vector3::Zero());
    }
    if (!moved && !turned) return;
    text_ +=
        '\n' + comment(
                   "Bonds take their reference state when forces are first computed: here, where nothing "
                   "has moved yet. A data file does not keep it.");
    say("run          0");
    text_ +=
        comment(model_.input.relaxed
                    ? "The static answer: from here on nothing moves but by the terms of second order that "
                      "a linear answer leaves out."
                    : "What supports prescribe, all at once; the state at rest does not depend on how.");
    if (moved) {
      for (const int i : {0, 1, 2})
        variable(std::string("start_u") + "xyz"[i], [&](std::size_t p) { return start(p)[i]; });
      for (const char axis : {'x', 'y', 'z'}) say("variable     start_{0} atom {0}+v_start_u{0}", axis);
      say("set          atom * x v_start_x y v_start_y z v_start_z");
    }
    if (turned) {
      const auto angle = [&](std::size_t p) { return start(p).tail<3>().norm(); };
      for (const int i : {0, 1, 2})
        variable(std::string("start_axis_") + "xyz"[i],
                 [&](std::size_t p) { return angle(p) > 0 ? start(p)[3 + i] / angle(p) : 0.0; });
      variable("start_degrees", [&](std::size_t p) { return angle(p) * (180 / EIGEN_PI); });
      say("set          atom * quat v_start_axis_x v_start_axis_y v_start_axis_z v_start_degrees");
    }
  }

  void run() {
    begin_elsewhere();
    const Index steps = model_.input.steps;
    const bool unwrapped = std::any_of(model_.box.periodic.begin(), model_.box.periodic.end(),
                                       [](bool repeats) { return repeats; });
    text_ += '\n' + comment(
                        "time step: below the critical one of the highest frequency; run: what the slowest "
                        "motion takes to die out, about. Longer where the last column still falls. Versions "
                        "before 30Mar2026 take angles from arc "
                        "cosines, whose noise it does not fall below.");
    say("timestep     {:.9g}", model_.input.time_step);
    say("variable     speed atom sqrt(vx*vx+vy*vy+vz*vz)");
    say("compute      fastest all reduce max v_speed");
    say("thermo_style custom step ke c_fastest");
    say("thermo       {}", std::max<Index>(1, steps / thermo_lines));
    say("thermo_modify format float %.8e");
    say("run          {}", steps);
    text_ += '\n' + comment("the end state; forces are what is left of them, damping included");
    say("compute      q all property/atom quatw quati quatj quatk");
    say("compute      bl all property/local batom1 batom2 btype");
    say("compute      bf all bond/local dist fx fy fz");
    const bool other_ids = model_.id_shift != 0;
    if (other_ids) say("variable     case_id atom id-{}", model_.id_shift);
    say("dump         d all custom 1 dump.final {} type {} c_q[1] c_q[2] c_q[3] c_q[4] vx vy vz omegax "
        "omegay "
        "omegaz fx fy fz tqx tqy tqz",
        other_ids ? "v_case_id" : "id", unwrapped ? "xu yu zu" : "x y z");
    if (other_ids) say("dump_modify  d colname v_case_id id");
    say("dump_modify  d format float %.17g sort id");
    say("dump         b all local 1 dump.bonds index c_bl[1] c_bl[2] c_bl[3] c_bf[1] c_bf[2] c_bf[3] "
        "c_bf[4]");
    say("dump_modify  b format float %.17g");
    say("run          0");
  }

  bool needs_atom_torques() const {
    return any([](const LammpsRole& role) {
             return !role.held_altogether() && (role.held >> 3) != 0 && !role.holds_all_rotations();
           }) ||
           std::any_of(model_.roles.load.begin(), model_.roles.load.end(),
                       [](const Vector6& load) { return load.tail<3>() != Vector3(Vector3::Zero()); });
  }

  const LammpsModel& model_;
  std::vector<LammpsVariable>& variables_;
  std::string text_;
};

}  // namespace

std::string lammps_deck(const LammpsModel& model, const ExportNotes& notes,
                        std::vector<LammpsVariable>& variables) {
  return Deck(model, variables).text(notes);
}

}  // namespace bondstatic
