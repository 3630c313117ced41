#include <memory>

#include "app/parsed_commands.hpp"

namespace bondstatic {

namespace {

ParsedCommand laws_command(CLI::App& app) {
  struct Arguments {
    std::string name;
    bool codes = false;
    bool strengths = false;
    bool json = false;
  };
  CLI::App* parser = app.add_subcommand(
      "laws", "bond laws and strengths: parameters, formulas, sources; other codes' conventions");
  const auto arguments = std::make_shared<Arguments>();
  parser->add_option("NAME", arguments->name, "only this law, criterion, or code");
  CLI::Option* strengths_listed =
      parser->add_flag("--strengths", arguments->strengths, "strength criteria: when bonds break");
  parser->add_flag("--codes", arguments->codes, "what other codes store of a bond, and what it means here")
      ->excludes(strengths_listed);
  parser->add_flag("--json", arguments->json, "print as JSON");
  return {parser,
          [arguments](const std::vector<std::string>&, Ranks*) {
            const auto list = arguments->codes ? codes : arguments->strengths ? strengths : laws;
            return list(arguments->name, arguments->json);
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
