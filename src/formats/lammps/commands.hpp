// Commands of a LAMMPS input script, one after the other: lines joined at &, comments gone, variables that
// are constants filled in, words apart (docs.lammps.org/Commands_parse.html). Nothing is executed.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/error.hpp"
#include "formats/lammps/formula.hpp"
#include "io/line_reader.hpp"

namespace bondstatic {

struct ScriptWord {
  std::string text;  ///< without its quotes; ${NAME} stays as it is where NAME is no constant
  int column = 1;
};

struct ScriptCommand {
  std::string file;
  int line = 0;
  std::vector<ScriptWord> words;  ///< never empty; the first is the command's name

  std::size_t arguments() const { return words.size() - 1; }
  const std::string& word(std::size_t i) const { return words.at(i).text; }
  Place place(std::size_t i = 0) const { return {file, line, words.at(i).column}; }
  std::string text() const;  ///< words, one blank apart
};

class CommandReader {
 public:
  static std::optional<CommandReader> open(const std::string& path, const Place& named_at,
                                           std::vector<Fault>& faults);

  /// Nothing at the end, or where reading is at fault. Follows `variable` commands on its way, and gives
  /// them out as well.
  std::optional<ScriptCommand> next(std::vector<Fault>& faults);

  const ScriptVariables& variables() const { return variables_; }

 private:
  explicit CommandReader(LineReader lines) : lines_(std::move(lines)) {}

  bool join_lines(std::string& text, int& line, std::vector<Fault>& faults);
  void follow_variable(const ScriptCommand& command);
  void forget_what_uses(const std::string& name);

  LineReader lines_;
  ScriptVariables variables_;
  ScriptVariables formulas_;  ///< of those that have one
};

}  // namespace bondstatic
