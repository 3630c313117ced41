// The commands as the command line knows them: their options, and what runs once they are read.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "app/commands.hpp"

namespace bondstatic {

struct ParsedCommand {
  CLI::App* parser;
  /// Arguments live in it. `backend_options`: what stands behind --, for the solver's own library.
  std::function<ExitCode(const std::vector<std::string>& backend_options, Ranks* ranks)> run;
  bool solves = false;    ///< takes options for the solver's own library
  bool on_ranks = false;  ///< may be run as several processes, of which the first speaks
};

/// CASE, --out, --set, --solver, --threads.
void add_solve_options(CLI::App& command, SolveArguments& arguments);

/// --report, of commands that write results.
void add_report_option(CLI::App& command, SolveArguments& arguments);

/// solve, sweep, relax, fracture, check, calibrate; report, of what they wrote.
std::vector<ParsedCommand> add_case_commands(CLI::App& app);

/// Models and runs of other codes: import, export, compare, translate.
std::vector<ParsedCommand> add_exchange_commands(CLI::App& app);

/// laws, solvers.
std::vector<ParsedCommand> add_listing_commands(CLI::App& app);

}  // namespace bondstatic
