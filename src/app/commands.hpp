// The commands of the program. Each prints its answer to standard output, throws Error where it fails, and
// returns what the program ends with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"
#include "bondstatic/types.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

struct SolveArguments {
  std::string file;
  std::string folder;                        ///< of the results; "" writes none
  std::vector<std::string> overrides;        ///< KEY=VALUE
  std::string solver;                        ///< "": the case's choice
  std::vector<std::string> backend_options;  ///< what stands behind --, for the solver's own library
  int threads = 0;                           ///< 0: the case's choice
  bool json = false;
  bool report = false;  ///< report.html among the results
};
/// Derivatives of the outputs to the parameters of the bonds' laws.
enum class Sensitivities { none, by_block, by_bond };

/// `ranks`: the processes that solve it together, null for one.
ExitCode solve(const SolveArguments& arguments, Sensitivities sensitivities = Sensitivities::none,
               Ranks* ranks = nullptr);

struct SweepArguments {
  SolveArguments solve;
  std::vector<std::string> vary;  ///< KEY=v1,v2 or KEY1:KEY2=a1:b1,a2:b2
};
ExitCode sweep(const SweepArguments& arguments);

/// Of commands that keep checkpoints.
struct LongRunArguments {
  SolveArguments solve;
  bool resume = false;
  double checkpoint_every = 60;  ///< seconds
};
ExitCode relax(const LongRunArguments& arguments);
ExitCode fracture(const LongRunArguments& arguments);

ExitCode check(const SolveArguments& arguments);

ExitCode calibrate(const SolveArguments& arguments);

/// All laws where `name` is empty.
ExitCode laws(const std::string& name, bool json);

/// What other codes' bonds are made of: all of them where `name` is empty.
ExitCode codes(const std::string& name, bool json);

/// When bonds break: all criteria where `name` is empty.
ExitCode strengths(const std::string& name, bool json);

struct ImportArguments {
  std::vector<std::string> files;
  std::string folder;  ///< of the case that is written
  std::string atom_style;
  std::vector<std::string> bond_columns;
  std::optional<Index> step;
  bool json = false;
};
ExitCode import_packing(const ImportArguments& arguments);

struct TranslateArguments {
  SolveArguments solve;
  std::string to;  ///< name of a code
};
ExitCode translate(const TranslateArguments& arguments);

struct ExportArguments {
  SolveArguments solve;
  std::string to;  ///< name of a format
  bool relaxed = false;
  bool has_load_case = false;
  std::string load_case;
};
ExitCode export_case(const ExportArguments& arguments);

struct CompareArguments {
  SolveArguments solve;
  std::string run;    ///< dump or table with the state of a run's particles
  std::string bonds;  ///< local dump or table with the forces of its bonds; may be ""
  std::vector<std::string> bond_columns, bond_force;
  std::optional<Index> step;
  bool every_step = false;
  double tolerance = 1e-3;
  std::optional<std::string> load_case;
};
ExitCode compare(const CompareArguments& arguments);

struct ReportArguments {
  std::vector<std::string> folders;  ///< of results
  std::string file;                  ///< "": report.html in the only folder, or in the current one
};
ExitCode show_report(const ReportArguments& arguments);

ExitCode solvers(bool json);

/// What --version prints: version, solvers, BLAS.
std::string version_text();

}  // namespace bondstatic
