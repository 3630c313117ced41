#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/parsed_commands.hpp"
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

  std::vector<ParsedCommand> commands;
  for (const auto add : {add_case_commands, add_exchange_commands, add_listing_commands})
    for (ParsedCommand& command : add(app)) commands.push_back(std::move(command));
  const std::vector<std::string> names = command_names(app);

  const std::string missing = fmt::format("a command is missing: {}", name_list(names));
  if (argc < 2) misused(missing, app);
  const std::string first = argv[1];
  if (!first.starts_with('-') && std::find(names.begin(), names.end(), first) == names.end())
    misused(with_suggestion(fmt::format("unknown command \"{}\"", first), first, names), app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    app.exit(success);
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    explain(app, error);
  }
  for (const ParsedCommand& command : commands) {
    if (!*command.parser) continue;
    if (!backend_options.empty() && !command.solves)
      misused(fmt::format("unexpected argument \"{}\"", backend_options.front()), *command.parser);
    if (!command.on_ranks) refuse_ranks(ranks, command.parser->get_name());
    return command.run(backend_options, ranks);
  }
  misused(missing, app);
}

}  // namespace bondstatic
