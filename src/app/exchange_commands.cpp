#include <memory>

#include "app/parsed_commands.hpp"
#include "app/with_report.hpp"

namespace bondstatic {

namespace {

ParsedCommand import_command(CLI::App& app) {
  CLI::App* parser = app.add_subcommand("import", "a packing of another DEM code as a case with its tables");
  const auto arguments = std::make_shared<ImportArguments>();
  parser
      ->add_option("FILE", arguments->files,
                   "files of one model: data files, dumps, tables, a LAMMPS input script")
      ->required();
  parser->add_option("--out", arguments->folder, "write case.toml and its tables to this folder")
      ->type_name("DIR")
      ->required();
  parser
      ->add_option("--atom-style", arguments->atom_style,
                   "columns of a LAMMPS data file: bpm/sphere, sphere, \"hybrid sphere bond\", ...")
      ->type_name("STYLE");
  parser
      ->add_option("--bond-columns", arguments->bond_columns,
                   "columns of a local dump that hold a bond's particles, and its type: c_1[1],c_1[2]")
      ->type_name("A,B[,TYPE]")
      ->delimiter(',')
      ->allow_extra_args(false);
  parser->add_option("--step", arguments->step, "the step of a dump to take (default: its last)")
      ->type_name("N");
  parser->add_flag("--json", arguments->json, "print the report as JSON");
  return {parser,
          [arguments](const std::vector<std::string>&, Ranks*) { return import_packing(*arguments); }};
}

ParsedCommand translate_command(CLI::App& app) {
  CLI::App* parser = app.add_subcommand(
      "translate", "the case's bonds in another code's numbers, and what its conventions change");
  const auto arguments = std::make_shared<TranslateArguments>();
  add_solve_options(*parser, arguments->solve);
  parser->add_option("--to", arguments->to, "one of those that `bondstatic laws --codes` lists")
      ->type_name("CODE")
      ->required();
  parser->add_flag("--json", arguments->solve.json, "print the answer as JSON");
  return {parser,
          [arguments](const std::vector<std::string>& backend_options, Ranks*) {
            arguments->solve.backend_options = backend_options;
            return translate(*arguments);
          },
          true};
}

ParsedCommand export_command(CLI::App& app) {
  CLI::App* parser =
      app.add_subcommand("export", "a case as files for another code: lammps, liggghts, csv, vtu");
  const auto arguments = std::make_shared<ExportArguments>();
  add_solve_options(*parser, arguments->solve);
  parser->get_option("--out")->required();
  parser->add_option("--to", arguments->to, "lammps, liggghts, csv or vtu")->type_name("FORMAT")->required();
  parser->add_flag("--relaxed", arguments->relaxed, "start at the static answer: nothing moves any more");
  CLI::Option* load_case =
      parser->add_option("--load-case", arguments->load_case, "the load case to export")->type_name("NAME");
  parser->add_flag("--json", arguments->solve.json, "print the report as JSON");
  return {parser,
          [arguments, load_case](const std::vector<std::string>& backend_options, Ranks*) {
            arguments->has_load_case = load_case->count() > 0;
            arguments->solve.backend_options = backend_options;
            return export_case(*arguments);
          },
          true};
}

ParsedCommand compare_command(CLI::App& app) {
  CLI::App* parser = app.add_subcommand(
      "compare", "a DEM run's end state beside the static answer: the same, and if not, why");
  const auto arguments = std::make_shared<CompareArguments>();
  add_solve_options(*parser, arguments->solve);
  add_report_option(*parser, arguments->solve);
  parser->add_option("RUN", arguments->run, "dump or table with ids, positions and orientations")->required();
  parser->add_option("--bonds", arguments->bonds, "local dump or table with the forces of the run's bonds")
      ->type_name("FILE");
  parser
      ->add_option("--bond-columns", arguments->bond_columns,
                   "columns of that file that hold a bond's particles: c_1[1],c_1[2]")
      ->type_name("A,B")
      ->delimiter(',')
      ->allow_extra_args(false);
  parser
      ->add_option("--bond-force", arguments->bond_force,
                   "and its force, and moment: c_2[2],c_2[3],c_2[4] (default: fx,fy,fz,mx,my,mz)")
      ->type_name("FX,FY,FZ[,MX,MY,MZ]")
      ->delimiter(',')
      ->allow_extra_args(false);
  parser->add_option("--step", arguments->step, "the step of a dump to take (default: its last)")
      ->type_name("N");
  parser->add_flag("--every-step", arguments->every_step, "all steps of a dump: how it comes to rest");
  parser
      ->add_option("--tolerance", arguments->tolerance,
                   "on the relative difference of displacements and rotations (default: 1e-3)")
      ->type_name("T");
  parser->add_option("--load-case", arguments->load_case, "the load case that the run has")
      ->type_name("NAME");
  parser->add_flag("--json", arguments->solve.json, "print the comparison as JSON");
  return {parser,
          [arguments](const std::vector<std::string>& backend_options, Ranks*) {
            arguments->solve.backend_options = backend_options;
            return with_report(arguments->solve, [&] { return compare(*arguments); });
          },
          true};
}

}  // namespace

std::vector<ParsedCommand> add_exchange_commands(CLI::App& app) {
  return {import_command(app), translate_command(app), export_command(app), compare_command(app)};
}

}  // namespace bondstatic
