#include <algorithm>
#include <memory>

#include "app/parsed_commands.hpp"
#include "app/with_report.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

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

void add_report_option(CLI::App& command, SolveArguments& arguments) {
  command.add_flag("--report", arguments.report, "write report.html into DIR, too: results to look at");
}

namespace {

ParsedCommand solve_command(CLI::App& app) {
  CLI::App* parser = app.add_subcommand("solve", "solve a case");
  const auto arguments = std::make_shared<SolveArguments>();
  add_solve_options(*parser, *arguments);
  add_report_option(*parser, *arguments);
  parser->add_flag("--json", arguments->json, "print the answer as JSON");
  const auto sensitivities = std::make_shared<Sensitivities>(Sensitivities::none);
  parser->add_flag_callback(
      "--sensitivities",
      [sensitivities] { *sensitivities = std::max(*sensitivities, Sensitivities::by_block); },
      "derivatives of the outputs to the parameters of the bonds, exact");
  parser->add_flag_callback(
      "--bond-sensitivities", [sensitivities] { *sensitivities = Sensitivities::by_bond; },
      "the same to each bond's own, too: bond_sensitivities.csv");
  return {parser,
          [arguments, sensitivities](const std::vector<std::string>& backend_options, Ranks* ranks) {
            arguments->backend_options = backend_options;
            if (ranks && ranks->rank() != 0) return solve(*arguments, *sensitivities, ranks);
            return with_report(*arguments, [&] { return solve(*arguments, *sensitivities, ranks); });
          },
          true, true};
}

ParsedCommand sweep_command(CLI::App& app) {
  CLI::App* parser = app.add_subcommand("sweep", "solve a case over a grid of values: one table (CSV)");
  const auto arguments = std::make_shared<SweepArguments>();
  add_solve_options(*parser, arguments->solve);
  add_report_option(*parser, arguments->solve);
  parser
      ->add_option(
          "--vary", arguments->vary,
          "a key and its values, bonds.0.young=50e9,70e9; several span a grid; keys that change together: "
          "K1:K2=a1:b1,a2:b2")
      ->type_name("KEY=v1,v2,...")
      ->allow_extra_args(false)
      ->required();
  return {parser,
          [arguments](const std::vector<std::string>& backend_options, Ranks*) {
            arguments->solve.backend_options = backend_options;
            return with_report(arguments->solve, [&] { return sweep(*arguments); });
          },
          true};
}

ParsedCommand long_run_command(CLI::App& app, const char* name, const char* what,
                               ExitCode (*run)(const LongRunArguments&)) {
  CLI::App* parser = app.add_subcommand(name, what);
  const auto arguments = std::make_shared<LongRunArguments>();
  add_solve_options(*parser, arguments->solve);
  add_report_option(*parser, arguments->solve);
  parser->add_flag("--json", arguments->solve.json, "print the answer as JSON");
  parser->add_flag("--resume", arguments->resume, "go on from the checkpoint in DIR where there is one");
  parser
      ->add_option("--checkpoint-every", arguments->checkpoint_every,
                   "write a checkpoint into DIR so often (default: 60)")
      ->type_name("SECONDS")
      ->check(CLI::NonNegativeNumber);
  return {parser,
          [arguments, run](const std::vector<std::string>& backend_options, Ranks*) {
            arguments->solve.backend_options = backend_options;
            return with_report(arguments->solve, [&] { return run(*arguments); });
          },
          true};
}

ParsedCommand relax_command(CLI::App& app) {
  return long_run_command(app, "relax", "run the case through time to its state of rest (explicit DEM)",
                          relax);
}

ParsedCommand fracture_command(CLI::App& app) {
  return long_run_command(app, "fracture",
                          "which bond breaks first, at what load, and what follows: [fracture]", fracture);
}

ParsedCommand check_command(CLI::App& app) {
  CLI::App* parser =
      app.add_subcommand("check", "static answer and explicit run of a case: a certificate that they agree");
  const auto arguments = std::make_shared<SolveArguments>();
  add_solve_options(*parser, *arguments);
  add_report_option(*parser, *arguments);
  parser->add_flag("--json", arguments->json, "print the certificate as JSON");
  return {parser,
          [arguments](const std::vector<std::string>& backend_options, Ranks*) {
            arguments->backend_options = backend_options;
            return with_report(*arguments, [&] { return check(*arguments); });
          },
          true};
}

ParsedCommand calibrate_command(CLI::App& app) {
  CLI::App* parser = app.add_subcommand(
      "calibrate", "find the bond parameters that make outputs of the case what was measured: [calibration]");
  const auto arguments = std::make_shared<SolveArguments>();
  add_solve_options(*parser, *arguments);
  add_report_option(*parser, *arguments);
  parser->add_flag("--json", arguments->json, "print the answer as JSON");
  return {parser,
          [arguments](const std::vector<std::string>& backend_options, Ranks*) {
            arguments->backend_options = backend_options;
            return with_report(*arguments, [&] { return calibrate(*arguments); });
          },
          true};
}

ParsedCommand report_command(CLI::App& app) {
  CLI::App* parser = app.add_subcommand(
      "report", "results of any command as one HTML file that opens in a browser, without a network");
  const auto arguments = std::make_shared<ReportArguments>();
  parser->add_option("DIR", arguments->folders, "folders of results, shown side by side")->required();
  parser->add_option("--out", arguments->file, "the file (default: report.html in DIR; of several, here)")
      ->type_name("FILE");
  return {parser, [arguments](const std::vector<std::string>&, Ranks*) { return show_report(*arguments); }};
}

}  // namespace

std::vector<ParsedCommand> add_case_commands(CLI::App& app) {
  return {solve_command(app), sweep_command(app),     relax_command(app), fracture_command(app),
          check_command(app), calibrate_command(app), report_command(app)};
}

}  // namespace bondstatic
