#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands.hpp"
#include "app/ranked.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {

namespace {

[[noreturn]] void misused(const std::string& message, const CLI::App& command) {
  throw Error(ExitCode::invalid_input,
              fmt::format("{}\n    see: {} --help", message,
                          command.get_parent() ? "bondstatic " + command.get_name() : "bondstatic"));
}

std::string with_suggestion(const std::string& message, const std::string& found,
                            const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(found, known);
  return nearest.empty() ? message : fmt::format("{}; did you mean \"{}\"?", message, nearest);
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// CLI11 knows what it could not place, not what it might have been.
[[noreturn]] void explain(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  for (const std::string& extra : command.remaining()) {
    const std::string name = extra.substr(0, extra.find('='));
    if (name.size() > 1 && name.front() == '-')
      misused(with_suggestion(fmt::format("unknown option {}", name), name, option_names(command)), command);
  }
  if (!command.remaining().empty())
    misused(fmt::format("unexpected argument \"{}\"", command.remaining().front()), command);
  misused(error.what(), command);
}

void add_solve_options(CLI::App& command, SolveArguments& arguments) {
  command.add_option("CASE", arguments.file, "case file (TOML)")->required();
  command.add_option("--out", arguments.folder, "write the results to this folder")->type_name("DIR");
  // One value an option: otherwise --set would swallow the case file behind it.
  command.add_option("--set", arguments.overrides, "override a key of the case: bonds.0.young=70e9")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--solver", arguments.solver, "one of those that `bondstatic solvers` lists")
      ->type_name("NAME");
  command
      .add_option("--threads", arguments.threads,
                  "threads for everything, fewer where the machine is busy (default: the cores at hand)")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

/// What follows "--" is for the solver's own library. CLI11 would refuse it for a subcommand, so that it is
/// taken off the end here.
std::vector<std::string> take_backend_options(int& argc, char** argv) {
  char** const end = argv + argc;
  char** const dashes = std::find(argv, end, std::string_view("--"));
  if (dashes == end) return {};
  argc = int(dashes - argv);
  return {dashes + 1, end};
}

}  // namespace

ExitCode run_command_line(int argc, char** argv, Ranks* ranks) {
  const std::vector<std::string> backend_options = take_backend_options(argc, argv);
  CLI::App app{"The static answer of a bonded-particle DEM model, right to the last digits."};
  app.name("bondstatic");
  app.footer("Options of the solver's own library (PETSc) stand at the end, behind --.");
  app.set_version_flag("--version", version_text);

  SolveArguments solve_arguments;
  CLI::App* solve_command = app.add_subcommand("solve", "solve a case");
  add_solve_options(*solve_command, solve_arguments);
  solve_command->add_flag("--json", solve_arguments.json, "print the answer as JSON");

  SweepArguments sweep_arguments;
  CLI::App* sweep_command =
      app.add_subcommand("sweep", "solve a case over a grid of values: one table (CSV)");
  add_solve_options(*sweep_command, sweep_arguments.solve);
  sweep_command
      ->add_option(
          "--vary", sweep_arguments.vary,
          "a key and its values, bonds.0.young=50e9,70e9; several span a grid; keys that change together: "
          "K1:K2=a1:b1,a2:b2")
      ->type_name("KEY=v1,v2,...")
      ->allow_extra_args(false)
      ->required();

  RelaxArguments relax_arguments;
  CLI::App* relax_command =
      app.add_subcommand("relax", "run the case through time to its state of rest (explicit DEM)");
  add_solve_options(*relax_command, relax_arguments.solve);
  relax_command->add_flag("--json", relax_arguments.solve.json, "print the answer as JSON");
  relax_command->add_flag("--resume", relax_arguments.resume,
                          "go on from the checkpoint in DIR where there is one");
  relax_command
      ->add_option("--checkpoint-every", relax_arguments.checkpoint_every,
                   "write a checkpoint into DIR so often (default: 60)")
      ->type_name("SECONDS")
      ->check(CLI::NonNegativeNumber);

  SolveArguments check_arguments;
  CLI::App* check_command =
      app.add_subcommand("check", "static answer and explicit run of a case: a certificate that they agree");
  add_solve_options(*check_command, check_arguments);
  check_command->add_flag("--json", check_arguments.json, "print the certificate as JSON");

  std::string law_name;
  bool as_json = false;
  CLI::App* laws_command = app.add_subcommand("laws", "bond laws: parameters, formulas, sources");
  laws_command->add_option("NAME", law_name, "only this law");
  laws_command->add_flag("--json", as_json, "print as JSON");

  CLI::App* solvers_command = app.add_subcommand("solvers", "linear solvers of this build, best first");
  solvers_command->add_flag("--json", as_json, "print as JSON");

  if (argc < 2) misused("a command is missing: solve, relax, check, sweep, laws or solvers", app);
  const std::string first = argv[1];
  const std::vector<std::string> commands = command_names(app);
  if (!first.starts_with('-') && std::find(commands.begin(), commands.end(), first) == commands.end())
    misused(with_suggestion(fmt::format("unknown command \"{}\"", first), first, commands), app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    app.exit(success);
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    explain(app, error);
  }
  for (SolveArguments* arguments :
       {&solve_arguments, &sweep_arguments.solve, &relax_arguments.solve, &check_arguments})
    arguments->backend_options = backend_options;
  if (!backend_options.empty() && (*laws_command || *solvers_command))
    misused(fmt::format("unexpected argument \"{}\"", backend_options.front()), app);
  if (*solve_command) return solve(solve_arguments, ranks);
  for (const CLI::App* command : {sweep_command, relax_command, check_command})
    if (*command) refuse_ranks(ranks, command->get_name());
  if (*sweep_command) return sweep(sweep_arguments);
  if (*relax_command) return relax(relax_arguments);
  if (*check_command) return check(check_arguments);
  if (*laws_command) return laws(law_name, as_json);
  if (*solvers_command) return solvers(as_json);
  misused("a command is missing: solve, relax, check, sweep, laws or solvers", app);
}

}  // namespace bondstatic
