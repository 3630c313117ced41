#include <memory>

#include "app/parsed_commands.hpp"

namespace bondstatic {

namespace {

ParsedCommand laws_command(CLI::App& app) {
  struct Arguments {
    std::string name;
    bool codes = false;
    bool json = false;
  };
  CLI::App* parser =
      app.add_subcommand("laws", "bond laws: parameters, formulas, sources; other codes' conventions");
  const auto arguments = std::make_shared<Arguments>();
  parser->add_option("NAME", arguments->name, "only this law, or code");
  parser->add_flag("--codes", arguments->codes, "what other codes store of a bond, and what it means here");
  parser->add_flag("--json", arguments->json, "print as JSON");
  return {parser,
          [arguments](const std::vector<std::string>&, Ranks*) {
            return (arguments->codes ? codes : laws)(arguments->name, arguments->json);
          },
          false, true};
}

ParsedCommand solvers_command(CLI::App& app) {
  CLI::App* parser = app.add_subcommand("solvers", "linear solvers of this build, best first");
  const auto json = std::make_shared<bool>(false);
  parser->add_flag("--json", *json, "print as JSON");
  return {parser, [json](const std::vector<std::string>&, Ranks*) { return solvers(*json); }, false, true};
}

}  // namespace

std::vector<ParsedCommand> add_listing_commands(CLI::App& app) {
  return {laws_command(app), solvers_command(app)};
}

}  // namespace bondstatic
