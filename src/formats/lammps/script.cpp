#include "formats/lammps/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "formats/lammps/bpm_rotational.hpp"
#include "io/nearest_name.hpp"
#include "io/number_field.hpp"

namespace bondstatic {
namespace {

constexpr std::size_t bpm_coefficients = bpm_rotational_columns.size();
constexpr std::size_t most_faults = 20;

/// Commands that say nothing of a state of rest: output, neighbour lists, communication, time.
bool is_silent(const std::string& name) {
  static const std::vector<std::string> names{
      "atom_modify",    "comm_modify",   "comm_style",   "compute",     "compute_modify", "dimension",
      "dump",           "dump_modify",   "echo",         "fix_modify",  "info",           "log",
      "mass",           "neigh_modify",  "neighbor",     "newton",      "package",        "print",
      "processors",     "restart",       "run_style",    "shell",       "special_bonds",  "suffix",
      "thermo",         "thermo_modify", "thermo_style", "timer",       "timestep",       "undump",
      "uncompute",      "variable",      "write_data",   "write_dump",  "write_restart",  "balance",
      "reset_timestep", "min_style",     "min_modify",   "pair_modify", "pair_write",     "bond_write",
      "velocity",       "region",        "partition",    "quit"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Commands that change the packing, or which commands are run: a reading that does not execute them may be
/// of another model.
bool changes_model(const std::string& name) {
  static const std::vector<std::string> names{
      "change_box",   "clear",          "create_atoms", "create_bonds", "create_box",   "delete_atoms",
      "delete_bonds", "displace_atoms", "if",           "include",      "jump",         "label",
      "molecule",     "next",           "python",       "read_dump",    "read_restart", "replicate",
      "rerun",        "reset_atoms",    "set",          "lattice",      "region_modify"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

class ScriptReader {
 public:
  /// `variables` are those at the command that is taken.
  ScriptReader(LammpsScript& script, const ScriptVariables& variables, std::vector<Fault>& faults)
      : script_(script), variables_(variables), faults_(faults) {}

  void take(const ScriptCommand& command) {
    using Handler = void (ScriptReader::*)(const ScriptCommand&);
    static const std::map<std::string, Handler, std::less<>> handlers{
        {"units", &ScriptReader::units},           {"atom_style", &ScriptReader::atom_style},
        {"boundary", &ScriptReader::boundary},     {"read_data", &ScriptReader::read_data},
        {"bond_style", &ScriptReader::bond_style}, {"bond_coeff", &ScriptReader::bond_coeff},
        {"pair_style", &ScriptReader::pair_style}, {"pair_coeff", &ScriptReader::pair_coeff},
        {"group", &ScriptReader::group},           {"fix", &ScriptReader::fix},
        {"unfix", &ScriptReader::unfix},           {"run", &ScriptReader::run},
        {"minimize", &ScriptReader::run},
    };
    const std::string& name = command.word(0);
    if (const auto found = handlers.find(name); found != handlers.end())
      return (this->*found->second)(command);
    if (is_silent(name)) {
      if (name != "variable" && name != "print") silent_.insert(name);
      return;
    }
    std::string& lines = changes_model(name) ? changing_[name] : unread_[name];
    lines += fmt::format("{}{}", lines.empty() ? "" : ", ", command.line);
  }

  void finish() {
    if (ran_) script_.fixes = fixes_at_run_;
    script_.variables = ran_ ? variables_at_run_ : variables_;
    if (!boundary_said_)
      script_.notes.assumed.push_back(
          "The script has no boundary command: LAMMPS's default, periodic in all directions.");
    if (!units_said_)
      script_.notes.assumed.push_back(
          "The script has no units command: LAMMPS's default, lj: numbers without dimension.");
    for (const auto& [name, lines] : changing_)
      script_.notes.left_out.push_back(
          fmt::format("{} (line {}) is not executed, though it may change the model: import the packing as "
                      "it is after it, from a data file or a dump.",
                      name, lines));
    if (!silent_.empty())
      script_.notes.left_out.push_back(fmt::format("Commands without a part in a state of rest: {}.",
                                                   name_list(std::vector(silent_.begin(), silent_.end()))));
    std::string names;
    for (const auto& [name, lines] : unread_)
      names += fmt::format("{}{} (line {})", names.empty() ? "" : ", ", name, lines);
    if (!names.empty()) script_.notes.left_out.push_back("Commands that are not read: " + names + ".");
  }

 private:
  void fault(const Place& place, const std::string& message, const std::string& cure) {
    if (++said_[cure] <= most_faults) faults_.push_back({place, message, cure});
  }

  /// So many arguments at least.
  bool has(const ScriptCommand& command, std::size_t least, const std::string& usage) {
    if (command.arguments() >= least) return true;
    fault(command.place(), fmt::format("{} with {} arguments", command.word(0), command.arguments()),
          "write " + usage);
    return false;
  }

  void units(const ScriptCommand& command) {
    if (!has(command, 1, "units si, or another style")) return;
    static const std::vector<std::string> known{"lj",  "real",     "metal", "si",
                                                "cgs", "electron", "micro", "nano"};
    const std::string& style = command.word(1);
    if (std::find(known.begin(), known.end(), style) == known.end()) {
      const std::string nearest = nearest_name(style, known);
      return fault(command.place(1),
                   fmt::format("units {} are unknown; there are: {}", style, name_list(known)),
                   nearest.empty() ? "choose one of them" : fmt::format("did you mean {}?", nearest));
    }
    script_.units = style;
    units_said_ = true;
    if (style == "real" || style == "metal" || style == "electron")
      script_.notes.assumed.push_back(
          fmt::format("Units {}: masses and forces are not consistent in them, so that gravity and runs "
                      "through time need other densities.",
                      style));
  }

  void atom_style(const ScriptCommand& command) {
    if (!has(command, 1, "atom_style bpm/sphere, or another style")) return;
    script_.atom_style.clear();
    for (std::size_t i = 1; i < command.words.size(); ++i)
      script_.atom_style += (i > 1 ? " " : "") + command.word(i);
  }

  void boundary(const ScriptCommand& command) {
    if (!has(command, 3, "boundary f f f, a letter or two for each direction: p periodic, f, s or m not"))
      return;
    boundary_said_ = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string& letters = command.word(i + 1);
      const bool known =
          !letters.empty() && letters.size() <= 2 && letters.find_first_not_of("pfsm") == std::string::npos;
      if (!known || (letters.size() == 2 && (letters[0] == 'p') != (letters[1] == 'p')))
        fault(command.place(i + 1), fmt::format("boundary \"{}\" is none", letters),
              "p is periodic at both faces; f, s, m or two of them are not");
      script_.periodic[i] = letters.starts_with('p');
    }
  }

  void read_data(const ScriptCommand& command) {
    if (!has(command, 1, "read_data FILE")) return;
    for (std::size_t i = 2; i < command.words.size(); ++i)
      for (const char* key : {"add", "offset", "shift", "group"})
        if (command.word(i) == key)
          script_.notes.left_out.push_back(
              fmt::format("read_data ... {} (line {}): the file is taken as it is.", key, command.line));
    if (!script_.data_file.empty())
      script_.notes.left_out.push_back(fmt::format(
          "{} (line {}): only the file of the last read_data is read.", read_data_, script_.data_place.line));
    read_data_ = command.text();
    const std::filesystem::path named = command.word(1);
    const auto folder = std::filesystem::path(script_.file).parent_path();
    script_.data_file = (named.is_absolute() ? named : folder / named).lexically_normal().string();
    script_.data_place = command.place(1);
  }

  /// Options that are yes or no.
  bool truth(const ScriptCommand& command, std::size_t word, bool fallback) {
    const std::string text = word < command.words.size() ? command.word(word) : "";
    if (text == "yes" || text == "on" || text == "true") return true;
    if (text == "no" || text == "off" || text == "false") return false;
    fault(command.place(std::min(word, command.words.size() - 1)),
          fmt::format("{} needs yes or no", command.word(word - 1)),
          fmt::format("write {} yes or no", command.word(word - 1)));
    return fallback;
  }

  void bond_style(const ScriptCommand& command) {
    if (!has(command, 1, "bond_style bpm/rotational")) return;
    script_.bond_style = command.word(1);
    script_.bond_coefficients.clear();
    script_.normalize = false;
    if (script_.bond_style != "bpm/rotational") {
      script_.notes.left_out.push_back(fmt::format(
          "bond_style {} (line {}): only bpm/rotational is read; give the bonds a law in the case.",
          script_.bond_style, command.line));
      return;
    }
    bool smooth = true, breaks = true;  // defaults of bond_bpm_rotational.rst
    for (std::size_t i = 2; i < command.words.size(); ++i) {
      if (command.word(i) == "smooth")
        smooth = truth(command, ++i, smooth);
      else if (command.word(i) == "break")
        breaks = truth(command, ++i, breaks);
      else if (command.word(i) == "normalize")
        script_.normalize = truth(command, ++i, false);
      else if (command.word(i) == "overlay/pair" && truth(command, ++i, false))
        script_.notes.left_out.push_back("overlay/pair yes: the contact forces between bonded particles.");
    }
    if (script_.normalize)
      script_.notes.taken.push_back("normalize yes: kn and ks are kr and ks over the bond's length.");
    if (smooth)
      script_.notes.left_out.push_back(
          "smooth yes (the default): LAMMPS softens bonds by 1 - B^4 as they come near their strength, "
          "B = 1; the static answer does not.");
    if (breaks) script_.notes.left_out.push_back("break yes (the default): bonds that fail; here all hold.");
  }

  std::optional<WholeRange> type_range(const std::string& text) {
    const std::size_t star = text.find('*');
    if (star == std::string::npos) {
      const auto one = script_whole(text);
      return one && *one >= 1 ? std::optional<WholeRange>({*one, *one, 1}) : std::nullopt;
    }
    const std::string low = text.substr(0, star), high = text.substr(star + 1);
    const auto first = low.empty() ? std::optional<Index>(1) : script_whole(low);
    const auto last =
        high.empty() ? std::optional<Index>(std::numeric_limits<Index>::max()) : script_whole(high);
    if (!first || !last || *first < 1 || *last < *first) return std::nullopt;
    return WholeRange{*first, *last, 1};
  }

  void bond_coeff(const ScriptCommand& command) {
    if (script_.bond_style != "bpm/rotational") {
      if (script_.bond_style.empty())
        fault(command.place(), "bond_coeff before bond_style",
              "LAMMPS wants bond_style bpm/rotational before it");
      return;  // of another style, which is noted
    }
    if (command.arguments() != bpm_coefficients + 1)
      return fault(command.place(),
                   fmt::format("bond_coeff of bpm/rotational with {} numbers",
                               std::max<std::size_t>(command.arguments(), 1) - 1),
                   "it has twelve: kr ks kt kb, four strengths, four dampings");
    const auto types = type_range(command.word(1));
    if (!types)
      return fault(command.place(1), fmt::format("\"{}\" is no bond type", command.word(1)),
                   "write a type from 1, or a range: *, 2*, *3, 2*3");
    ScriptBondCoefficients coefficients{*types, {}, command.place()};
    for (std::size_t i = 2; i < command.words.size(); ++i)
      if (const auto number = script_number(command, i, variables_, faults_))
        coefficients.numbers.push_back(*number);
    if (coefficients.numbers.size() < bpm_coefficients) return;
    for (std::size_t i = 0; i < bpm_rotational_stiffnesses; ++i)
      if (coefficients.numbers[i] < 0)
        fault(command.place(i + 2), fmt::format("stiffness {} is negative", coefficients.numbers[i]),
              "kr, ks, kt, kb are not negative");
    script_.bond_coefficients.push_back(std::move(coefficients));
  }

  void pair_style(const ScriptCommand& command) {
    const std::string style = command.arguments() > 0 ? command.word(1) : "";
    if (style == "none" || style == "zero") return;
    script_.notes.left_out.push_back(
        fmt::format("pair_style {} (line {}): contact forces between particles that no bond joins.", style,
                    command.line));
  }
  void pair_coeff(const ScriptCommand&) {}  // said with its pair_style

  void group(const ScriptCommand& command) {
    if (auto made = read_script_group(command, script_.notes, faults_))
      script_.groups.push_back(std::move(*made));
  }

  void fix(const ScriptCommand& command) {
    if (!has(command, 3, "fix ID GROUP STYLE and what it takes")) return;
    const auto same = std::find_if(script_.fixes.begin(), script_.fixes.end(),
                                   [&](const ScriptFix& fix) { return fix.id() == command.word(1); });
    if (same == script_.fixes.end())
      script_.fixes.push_back({command});
    else
      *same = {command};
  }

  void unfix(const ScriptCommand& command) {
    if (!has(command, 1, "unfix ID")) return;
    std::erase_if(script_.fixes, [&](const ScriptFix& fix) { return fix.id() == command.word(1); });
  }

  void run(const ScriptCommand&) {
    fixes_at_run_ = script_.fixes;
    variables_at_run_ = variables_;
    ran_ = true;
  }

  LammpsScript& script_;
  const ScriptVariables& variables_;
  std::vector<Fault>& faults_;
  std::map<std::string, std::size_t> said_;               ///< of each kind of fault, which its cure tells
  std::map<std::string, std::string> changing_, unread_;  ///< lines of each command that is not followed
  std::set<std::string> silent_;
  std::vector<ScriptFix> fixes_at_run_;
  ScriptVariables variables_at_run_;
  std::string read_data_;  ///< the command that named script_.data_file
  bool ran_ = false, boundary_said_ = false, units_said_ = false;
};

}  // namespace

bool is_lammps_script_name(const std::string& path) {
  const std::filesystem::path name = std::filesystem::path(path).filename();
  const std::string extension = name.extension().string();
  return name.string().starts_with("in.") || extension == ".in" || extension == ".lammps" ||
         extension == ".lmp";
}

std::optional<double> script_number(const ScriptCommand& command, std::size_t word,
                                    const ScriptVariables& variables, std::vector<Fault>& faults) {
  const std::string& text = command.word(word);
  if (const double value = number_field(text); std::isfinite(value)) return value;
  if (text.starts_with("v_"))
    if (const auto constant = constant_formula(text, variables)) return constant;
  const bool variable = text.starts_with("v_") || text.find('$') != std::string::npos;
  faults.push_back(
      {command.place(word), fmt::format("\"{}\" is no {}", text, variable ? "constant" : "finite number"),
       variable ? "write its number: variables are followed where they are constants, defined above"
                : "write a finite number"});
  return std::nullopt;
}

std::optional<LammpsScript> read_lammps_script(const std::string& path, const Place& named_at,
                                               std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  auto commands = CommandReader::open(path, named_at, faults);
  if (!commands) return std::nullopt;
  LammpsScript script;
  script.file = path;
  ScriptReader reader(script, commands->variables(), faults);
  while (const auto command = commands->next(faults)) reader.take(*command);
  reader.finish();
  if (faults.size() != before) return std::nullopt;
  return script;
}

}  // namespace bondstatic
