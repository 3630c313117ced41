#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <new>

#include "app/commands.hpp"
#include "app/run_case.hpp"
#include "app/single_file.hpp"
#include "app/status_line.hpp"
#include "app/vary.hpp"
#include "io/csv_writer.hpp"

namespace bondstatic {

namespace {

constexpr const char* table_name = "sweep.csv";

struct Outcome {
  ExitCode code = ExitCode::done;
  std::string message;
  std::vector<OutputValue> outputs;
  std::string particles, bonds;  ///< how many; "" where the case could not be read
};

std::string status_of(ExitCode code) {
  switch (code) {
    case ExitCode::done:
      return "done";
    case ExitCode::invalid_input:
      return "invalid-input";
    case ExitCode::mechanism:
      return "mechanism";
    case ExitCode::not_accurate:
      return "not-accurate";
    case ExitCode::out_of_memory:
      return "out-of-memory";
    default:
      return "internal-error";
  }
}

/// An internal error is worst; otherwise the later the failure, the worse.
int severity(ExitCode code) {
  return code == ExitCode::internal ? 1000 : int(code);
}

Outcome outcome_at(const SolveArguments& arguments, const std::vector<std::string>& overrides) {
  Outcome outcome;
  try {
    const Case given = read_case(arguments, overrides);
    outcome.particles = std::to_string(given.model.particles.size());
    outcome.bonds = std::to_string(given.model.bonds.size());
    outcome.outputs = answer(given, nullptr).outputs;
  } catch (const Error& error) {
    outcome.code = error.code();
    outcome.message = error.what();
  } catch (const std::bad_alloc&) {
    outcome.code = ExitCode::out_of_memory;
    outcome.message = "out of memory";
  }
  return outcome;
}

std::vector<std::string> assignments(const std::vector<std::string>& keys,
                                     const std::vector<std::string>& values) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < keys.size(); ++i) all.push_back(keys[i] + "=" + values[i]);
  return all;
}

std::string joined(const std::vector<std::string>& parts, const char* separator) {
  return fmt::format("{}", fmt::join(parts, separator));
}

/// Keys, numbers of particles and bonds, outputs, status; outputs stay empty where a point failed.
std::string table_of(const std::vector<std::string>& keys,
                     const std::vector<std::vector<std::string>>& points,
                     const std::vector<Outcome>& outcomes) {
  const auto solved = std::find_if(outcomes.begin(), outcomes.end(),
                                   [](const Outcome& outcome) { return outcome.code == ExitCode::done; });
  std::vector<std::string> names;
  if (solved != outcomes.end())
    for (const OutputValue& output : solved->outputs) names.push_back(output.name);

  std::vector<std::string> fields;
  for (const std::string& key : keys) fields.push_back(csv_field(key));
  fields.insert(fields.end(), {"particles", "bonds"});
  for (const std::string& name : names) fields.push_back(csv_field(name));
  fields.push_back("status");
  std::string text = joined(fields, ",") + "\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    fields.clear();
    for (const std::string& value : points[i]) fields.push_back(csv_field(value));
    fields.insert(fields.end(), {outcomes[i].particles, outcomes[i].bonds});
    // By name: a point may vary what is asked for.
    for (const std::string& name : names) {
      const auto& outputs = outcomes[i].outputs;
      const auto found = std::find_if(outputs.begin(), outputs.end(),
                                      [&](const OutputValue& output) { return output.name == name; });
      fields.push_back(found == outputs.end() ? "" : csv_number(found->value));
    }
    fields.push_back(status_of(outcomes[i].code));
    text += joined(fields, ",") + "\n";
  }
  return text;
}

}  // namespace

ExitCode sweep(const SweepArguments& arguments) {
  std::vector<Variation> variations;
  std::vector<std::string> keys;
  for (const std::string& text : arguments.vary) {
    variations.push_back(parse_variation(text));
    for (const std::string& key : variations.back().keys) {
      if (std::find(keys.begin(), keys.end(), key) != keys.end())
        throw Error(ExitCode::invalid_input,
                    fmt::format("--vary {}: {} is varied twice\n    cure: vary each key once", text, key));
      keys.push_back(key);
    }
  }
  const auto points = grid_points(variations);
  const std::string& folder = arguments.solve.folder;
  if (!folder.empty()) check_single_file(folder, table_name);

  StatusLine status;
  std::vector<Outcome> outcomes;
  ExitCode worst = ExitCode::done;
  for (const auto& values : points) {
    const std::vector<std::string> here = assignments(keys, values);
    status.show(fmt::format("{}/{}  {}", outcomes.size() + 1, points.size(), joined(here, " ")));
    std::vector<std::string> overrides = arguments.solve.overrides;
    overrides.insert(overrides.end(), here.begin(), here.end());
    outcomes.push_back(outcome_at(arguments.solve, overrides));
    const Outcome& outcome = outcomes.back();
    if (severity(outcome.code) > severity(worst)) worst = outcome.code;
    if (outcome.code == ExitCode::done) continue;
    status.clear();
    const bool again = outcomes.size() > 1 && outcomes[outcomes.size() - 2].message == outcome.message;
    fmt::print(stderr, "at {}: {}\n", joined(here, ", "), again ? "the same" : "\n" + outcome.message);
  }
  status.clear();
  // Input that is wrong at every point leaves nothing to tabulate.
  if (std::all_of(outcomes.begin(), outcomes.end(),
                  [](const Outcome& outcome) { return outcome.code == ExitCode::invalid_input; }))
    return worst;
  const std::string table = table_of(keys, points, outcomes);
  if (folder.empty()) {
    fmt::print("{}", table);
  } else {
    write_single_file(folder, table_name, table);
    fmt::print("{}\n", (std::filesystem::path(folder) / table_name).string());
  }
  return worst;
}

}  // namespace bondstatic
