#include "formats/lammps/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace bondstatic {
namespace {

constexpr std::size_t longest_command = 1 << 20;
constexpr std::string_view blanks = " \t\r\f\v";

/// Which quote the lines of a command leave open.
struct OpenQuote {
  std::string quote;  ///< ", ' or """; empty where none
  bool comment = false;

  void read(std::string_view line) {
    for (std::size_t i = 0; i < line.size() && !comment;) {
      if (!quote.empty()) {
        const std::size_t end = line.find(quote, i);
        if (end == std::string_view::npos) return;
        i = end + quote.size();
        quote.clear();
      } else if (line[i] == '"' || line[i] == '\'') {
        quote = line.substr(i).starts_with("\"\"\"") ? "\"\"\"" : std::string(1, line[i]);
        i += quote.size();
      } else {
        comment = line[i++] == '#';
      }
    }
  }
};

/// Whether a formula asks for the value of a variable, named "v_NAME".
bool asks_for(std::string_view formula, std::string_view variable) {
  const auto goes_on = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); };
  for (std::size_t at = 0; (at = formula.find(variable, at)) != std::string_view::npos; ++at) {
    const std::size_t end = at + variable.size();
    if (end == formula.size() || !goes_on(formula[end])) return true;
  }
  return false;
}

/// The value of the $ expression at the beginning of `text` and how long the expression is; length 0 where
/// it has no constant value.
struct Expansion {
  std::string value;
  std::size_t length = 0;
};
Expansion expansion(std::string_view text, const ScriptVariables& variables) {
  if (text.size() < 2) return {};
  if (text[1] == '(') {
    std::size_t end = 2;
    for (int depth = 1; end < text.size(); ++end) {
      depth += (text[end] == '(') - (text[end] == ')');
      if (depth == 0) break;
    }
    if (end == text.size()) return {};
    const std::string_view inside = text.substr(2, end - 2);
    // A format after :% rounds the number, and is refused as no part of a formula.
    const auto number = constant_formula(inside, variables);
    return number ? Expansion{fmt::format("{}", *number), end + 1} : Expansion{};
  }
  const bool braces = text[1] == '{';
  const std::size_t end = braces ? text.find('}') : 2;
  if (end == std::string_view::npos) return {};
  const auto found = variables.find(braces ? text.substr(2, end - 2) : text.substr(1, 1));
  if (found == variables.end()) return {};
  return {found->second, end + braces};
}

/// Words of a command, comments cut off and $ filled in outside of quotes.
std::vector<ScriptWord> words_of(std::string_view text, bool whole_line, const ScriptVariables& variables) {
  std::vector<ScriptWord> words;
  bool inside = false;
  const auto append = [&](std::string_view piece, std::size_t at) {
    if (!inside) words.push_back({"", whole_line ? int(at) + 1 : 1});
    inside = true;
    words.back().text += piece;
  };
  for (std::size_t i = 0; i < text.size() && text[i] != '#';) {
    const char c = text[i];
    if (blanks.find(c) != std::string_view::npos || c == '\n') {
      inside = false;
      ++i;
    } else if ((c == '"' || c == '\'') && !inside) {
      const std::string_view quote =
          text.substr(i).starts_with("\"\"\"") ? text.substr(i, 3) : text.substr(i, 1);
      const std::size_t end = std::min(text.find(quote, i + quote.size()), text.size());
      append(text.substr(i + quote.size(), end - i - quote.size()), i);
      inside = false;
      i = end + quote.size();
    } else if (const Expansion expanded = c == '$' ? expansion(text.substr(i), variables) : Expansion{};
               expanded.length > 0) {
      // A value may hold several words.
      for (const char v : expanded.value)
        if (blanks.find(v) != std::string_view::npos)
          inside = false;
        else
          append(std::string_view(&v, 1), i);
      i += expanded.length;
    } else {
      append(text.substr(i, 1), i);
      ++i;
    }
  }
  return words;
}

}  // namespace

std::string ScriptCommand::text() const {
  std::string all;
  for (const ScriptWord& word : words) all += (all.empty() ? "" : " ") + word.text;
  return all;
}

std::optional<CommandReader> CommandReader::open(const std::string& path, const Place& named_at,
                                                 std::vector<Fault>& faults) {
  auto lines = LineReader::open(path, named_at, faults);
  if (!lines) return std::nullopt;
  return CommandReader(std::move(*lines));
}

/// The next line with those that it goes on to; false at the end.
bool CommandReader::join_lines(std::string& text, int& line, std::vector<Fault>& faults) {
  const auto first = lines_.next(faults);
  if (!first) return false;
  text = *first;
  line = lines_.line();
  OpenQuote open;
  open.read(text);
  while (true) {
    const std::size_t last = text.find_last_not_of(blanks);
    const bool goes_on = last != std::string::npos && text[last] == '&';
    const std::string& quote = open.quote;
    if (!goes_on && quote != "\"\"\"") {
      if (quote.empty()) return true;
      faults.push_back({{lines_.file(), line, 1},
                        fmt::format("the quote {} is not closed", quote),
                        fmt::format("close it with {}, or end the line with & to go on", quote)});
      text.clear();
      return true;
    }
    if (goes_on && quote != "\"\"\"") text.resize(last);
    const auto more = lines_.next(faults);
    if (!more && lines_.failed()) return false;
    if (!more && quote.empty()) return true;
    if (!more || text.size() > longest_command) {
      faults.push_back(
          {{lines_.file(), line, 1},
           more ? "a command longer than 1 MiB" : fmt::format("the quote {} is not closed", quote),
           "check the quotes and the & at the ends of the lines from here on"});
      text.clear();
      return more.has_value();
    }
    if (quote == "\"\"\"") text += '\n';
    text += *more;
    open.read(*more);
  }
}

void CommandReader::follow_variable(const ScriptCommand& command) {
  if (command.word(0) != "variable" || command.arguments() < 2) return;
  const std::string& name = command.word(1);
  const std::string& style = command.word(2);
  std::string value;
  for (std::size_t i = 3; i < command.words.size(); ++i) value += (i > 3 ? " " : "") + command.word(i);
  const auto known = variables_.find(name);
  if (style == "index" && known != variables_.end()) return;  // keeps what it was
  const std::optional<std::string> before =
      known == variables_.end() ? std::nullopt : std::optional(known->second);
  variables_.erase(name);
  formulas_.erase(name);
  if (command.arguments() >= 3 && (style == "equal" || style == "internal")) {
    if (const auto number = constant_formula(value, variables_)) {
      variables_[name] = fmt::format("{}", *number);
      formulas_[name] = value;
    }
  } else if (command.arguments() >= 3 && (style == "string" || style == "index")) {
    variables_[name] = style == "string" ? value : command.word(3);
  }
  const auto now = variables_.find(name);
  if (before && (now == variables_.end() || now->second != *before)) forget_what_uses(name);
}

/// LAMMPS evaluates a formula where it is used, with the values there.
void CommandReader::forget_what_uses(const std::string& name) {
  std::vector<std::string> changed{name};
  while (!changed.empty()) {
    const std::string used = "v_" + changed.back();
    changed.pop_back();
    std::erase_if(formulas_, [&](const auto& formula) {
      if (!asks_for(formula.second, used)) return false;
      variables_.erase(formula.first);
      changed.push_back(formula.first);
      return true;
    });
  }
}

std::optional<ScriptCommand> CommandReader::next(std::vector<Fault>& faults) {
  std::string text;
  int line = 0;
  while (join_lines(text, line, faults)) {
    ScriptCommand command{lines_.file(), line, words_of(text, lines_.line() == line, variables_)};
    if (command.words.empty()) continue;
    follow_variable(command);
    return command;
  }
  return std::nullopt;
}

}  // namespace bondstatic
