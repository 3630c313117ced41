#include "formats/lammps/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/number_field.hpp"

namespace bondstatic {
namespace {

using Style = ScriptGroup::Style;
using Ranges = std::vector<WholeRange>;

/// A, A:B or A:B:C.
std::optional<WholeRange> sequence(std::string_view text) {
  std::vector<Index> numbers;
  while (true) {
    const std::size_t colon = text.find(':');
    const auto number = script_whole(text.substr(0, colon));
    if (!number || numbers.size() == 3) return std::nullopt;
    numbers.push_back(*number);
    if (colon == std::string_view::npos) break;
    text.remove_prefix(colon + 1);
  }
  WholeRange range{numbers[0], numbers[0]};
  if (numbers.size() > 1) range.last = numbers[1];
  if (numbers.size() > 2) range.step = numbers[2];
  return range.step < 1 ? std::nullopt : std::optional(range);
}

/// "<= 150", "<> 2 4"; nothing where the comparison is unknown or misses a number.
std::optional<Ranges> comparison(const ScriptCommand& command) {
  constexpr Index smallest = std::numeric_limits<Index>::min(), largest = std::numeric_limits<Index>::max();
  const auto operand = [&](std::size_t word) {
    return word < command.words.size() ? script_whole(command.word(word)) : std::nullopt;
  };
  const std::string& logical = command.word(3);
  const auto value = operand(4);
  if (!value) return std::nullopt;
  const Index v = *value;
  if (logical == "<=") return Ranges{{smallest, v}};
  if (logical == "<") return Ranges{{smallest, v - 1}};
  if (logical == ">=") return Ranges{{v, largest}};
  if (logical == ">") return Ranges{{v + 1, largest}};
  if (logical == "==") return Ranges{{v, v}};
  if (logical == "!=") return Ranges{{smallest, v - 1}, {v + 1, largest}};
  const auto high = operand(5);
  if (logical == "<>" && high) return Ranges{{v, *high}};
  return std::nullopt;
}

/// What `group NAME type|id ...` lists; nothing, and a fault, where that is at fault.
std::optional<Ranges> listed(const ScriptCommand& command, std::vector<Fault>& faults) {
  if (command.word(3).find_first_of("<>=!") != std::string::npos) {
    auto found = comparison(command);
    if (!found)
      faults.push_back({command.place(3), fmt::format("\"{}\" compares with no whole number", command.text()),
                        "write e.g. group NAME id <= 100, or group NAME type <> 2 4"});
    return found;
  }
  Ranges all;
  for (std::size_t i = 3; i < command.words.size(); ++i) {
    const auto range = sequence(command.word(i));
    if (!range) {
      faults.push_back({command.place(i),
                        fmt::format("\"{}\" is no {} of a group", command.word(i), command.word(2)),
                        "write whole numbers, A:B or A:B:STEP; labels are not read"});
      return std::nullopt;
    }
    all.push_back(*range);
  }
  return all;
}

/// The type of each of the model's groups, absent where it is none.
std::vector<std::optional<Index>> types_of_groups(const ForeignModel& model) {
  std::vector<std::optional<Index>> types;
  for (const std::string& name : model.group_names)
    types.push_back(name.starts_with("type ") ? script_whole(std::string_view(name).substr(5))
                                              : std::nullopt);
  return types;
}

/// Members that a list of types or ids makes.
Members listed_members(const ScriptGroup& group, const ForeignModel& model) {
  const auto listed = [&](std::optional<Index> value) {
    return value && std::any_of(group.ranges.begin(), group.ranges.end(),
                                [&](const WholeRange& range) { return range.contains(*value); });
  };
  std::vector<char> members(model.particles.size());
  if (group.style == Style::id) {
    for (std::size_t p = 0; p < members.size(); ++p) members[p] = listed(model.particles[p].id);
    return members;
  }
  const auto types = types_of_groups(model);
  if (model.group.empty() || std::none_of(types.begin(), types.end(), [](const auto& type) { return type; }))
    return std::nullopt;
  for (std::size_t p = 0; p < members.size(); ++p) members[p] = listed(types[std::size_t(model.group[p])]);
  return members;
}

/// Members that other groups make; they have all been looked up.
Members combined_members(const ScriptGroup& group, const std::vector<const Members*>& operands) {
  for (const Members* operand : operands)
    if (!*operand) return std::nullopt;
  std::vector<char> members = **operands.front();
  for (std::size_t o = 1; o < operands.size(); ++o) {
    const std::vector<char>& other = **operands[o];
    for (std::size_t p = 0; p < members.size(); ++p)
      members[p] = group.style == Style::subtract ? members[p] && !other[p]
                   : group.style == Style::unite  ? members[p] || other[p]
                                                  : members[p] && other[p];
  }
  return members;
}

}  // namespace

std::optional<Index> script_whole(std::string_view text) {
  constexpr Index most = 999'999'999'999'999'999;  // room for what comparisons add
  const auto value = whole_number_field(text);
  return value && *value <= most && *value >= -most ? value : std::nullopt;
}

std::optional<ScriptGroup> read_script_group(const ScriptCommand& command, ImportNotes& notes,
                                             std::vector<Fault>& faults) {
  struct Known {
    Style style;
    std::size_t least;  ///< arguments
  };
  static const std::map<std::string, Known, std::less<>> styles{
      {"type", {Style::type, 3}},         {"id", {Style::id, 3}},        {"union", {Style::unite, 3}},
      {"subtract", {Style::subtract, 4}}, {"empty", {Style::clear, 2}},  {"intersect", {Style::intersect, 4}},
      {"clear", {Style::clear, 2}},       {"delete", {Style::clear, 2}},
  };
  const std::string style = command.arguments() < 2 ? "" : command.word(2);
  const auto found = styles.find(style);
  if (command.arguments() < (found == styles.end() ? 2 : found->second.least)) {
    faults.push_back({command.place(), fmt::format("\"{}\" says too little", command.text()),
                      "write group NAME type 1 2, group NAME id 1:100, group NAME subtract all OTHER, ..."});
    return std::nullopt;
  }
  if (style == "static") return std::nullopt;
  ScriptGroup made{command.word(1), Style::unknown, {}, {}, command.place(1)};
  if (found == styles.end()) {
    notes.left_out.push_back(fmt::format(
        "group {} {} (line {}): its particles cannot be told from the script; so what fixes do to them.",
        made.name, style, command.line));
    return made;
  }
  made.style = found->second.style;
  if (made.style == Style::type || made.style == Style::id) {
    auto ranges = listed(command, faults);
    if (!ranges) return std::nullopt;
    made.ranges = std::move(*ranges);
  } else {
    for (std::size_t i = 3; i < command.words.size(); ++i) made.operands.push_back(command.word(i));
  }
  return made;
}

std::map<std::string, Members> script_group_members(const std::vector<ScriptGroup>& groups,
                                                    const ForeignModel& model, std::vector<Fault>& faults) {
  const std::vector<char> nobody(model.particles.size());
  std::map<std::string, Members> members{{"all", std::vector<char>(model.particles.size(), 1)}};
  for (const ScriptGroup& group : groups) {
    if (group.style == Style::clear) {
      members[group.name] = nobody;
      continue;
    }
    Members added;
    if (group.style == Style::type || group.style == Style::id) {
      added = listed_members(group, model);
    } else if (group.style != Style::unknown) {
      std::vector<const Members*> operands;
      for (const std::string& name : group.operands)
        if (const auto operand = members.find(name); operand != members.end())
          operands.push_back(&operand->second);
        else
          faults.push_back({group.place,
                            fmt::format("group {} is made of {}, which is no group", group.name, name),
                            "make that group above"});
      if (operands.size() == group.operands.size()) added = combined_members(group, operands);
    }
    Members& all = members.try_emplace(group.name, nobody).first->second;
    if (!added || !all)
      all = std::nullopt;
    else
      for (std::size_t p = 0; p < all->size(); ++p) (*all)[p] |= (*added)[p];
  }
  return members;
}

}  // namespace bondstatic
