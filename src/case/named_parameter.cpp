#include "case/named_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

struct Reason {
  std::string message, cure;
};

bool is_number(const Parameter& parameter) {
  return !parameter.whole && !parameter.truth;
}

std::vector<std::string> number_names(const BondLaw& law) {
  std::vector<std::string> names;
  for (const Parameter& parameter : law.parameters)
    if (is_number(parameter)) names.push_back(parameter.name);
  return names;
}

/// What the block gives in place of a parameter, "" where nothing does.
std::string rival_of(const BondLaw& law, const BondBlock& block, const std::string& name) {
  for (const Alternatives& ways : law.alternatives) {
    const auto has = [](const std::vector<std::string>& way, const std::string& one) {
      return std::find(way.begin(), way.end(), one) != way.end();
    };
    if (std::none_of(ways.begin(), ways.end(), [&](const auto& way) { return has(way, name); })) continue;
    for (const auto& way : ways)
      for (const std::string& other : way)
        if (!has(way, name) && !std::isnan(block.parameters[std::size_t(law.find(other))])) return other;
  }
  return {};
}

/// Why a block's parameter could not be calibrated; nothing where it can.
std::optional<Reason> obstacle(const Model& model, std::size_t b, const std::string& name) {
  const BondBlock& block = model.blocks[b];
  const BondLaw& law = *find_bond_law(block.law);
  const std::vector<std::string> names = number_names(law);
  const Index p = law.find(name);
  if (name.starts_with("strength."))
    return Reason{fmt::format("bonds.{}.{}: strengths change nothing in a static answer", b, name),
                  "choose one of: " + name_list(names)};
  if (p < 0) {
    const std::string nearest = nearest_name(name, names);
    return Reason{fmt::format("the law of bonds.{}, {}, takes no {}; it takes: {}", b, law.name, name,
                              name_list(names)),
                  nearest.empty() ? "choose one of them" : fmt::format("did you mean \"{}\"?", nearest)};
  }
  const Parameter& parameter = law.parameters[std::size_t(p)];
  if (!is_number(parameter))
    return Reason{fmt::format("{} is {}, which cannot be calibrated", name,
                              parameter.truth ? "true or false" : "a whole number"),
                  "choose one of: " + name_list(names)};
  if (std::isnan(block.parameters[std::size_t(p)])) {
    const std::string rival = rival_of(law, block, name);
    if (rival.empty())
      return Reason{fmt::format("bonds.{} does not give {}", b, name),
                    fmt::format("add {} = .. to the block", name)};
    return Reason{fmt::format("bonds.{} gives {}, not {}", b, rival, name),
                  fmt::format("calibrate {}, or give {} in its place", rival, name)};
  }
  const auto own = block.overrides.find(std::size_t(p));
  const auto is_given = [](double value) { return !std::isnan(value); };
  if (own != block.overrides.end() && std::all_of(own->second.begin(), own->second.end(), is_given))
    return Reason{fmt::format("each bond of bonds.{} has a {} of its own", b, name),
                  "take the column out of the bond file, so that the bonds follow the block"};
  return std::nullopt;
}

NamedParameter of_one_block(const Model& model, const std::string& key) {
  const std::size_t dot = key.find('.', 6);
  std::size_t block = 0;
  const char* const begin = key.data() + 6;
  const char* const end = key.data() + std::min(dot, key.size());
  const auto [stop, error] = std::from_chars(begin, end, block);
  if (dot == std::string::npos || dot + 1 == key.size() || error != std::errc() || stop != end)
    return {{},
            fmt::format("\"{}\" names no parameter of a block", key),
            "write for instance \"bonds.0.young\", or \"young\" for all blocks that give it"};
  if (block >= model.blocks.size())
    return {{},
            fmt::format("there is no bonds.{}", block),
            fmt::format("blocks of bonds run from 0 to {}", Index(model.blocks.size()) - 1)};
  const std::string name = key.substr(dot + 1);
  if (auto why = obstacle(model, block, name)) return {{}, why->message, why->cure};
  const Index p = find_bond_law(model.blocks[block].law)->find(name);
  return {{{Index(block), std::size_t(p)}}, "", ""};
}

}  // namespace

NamedParameter find_parameter(const Model& model, const std::string& key) {
  if (key.starts_with("bonds.")) return of_one_block(model, key);
  NamedParameter found;
  bool taken = false;  // by some law, so that its obstacle says more than that the others do not take it
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const Index p = find_bond_law(model.blocks[b].law)->find(key);
    const auto why = obstacle(model, b, key);
    if (!why) {
      found.places.push_back({Index(b), std::size_t(p)});
    } else if (found.message.empty() || (p >= 0 && !taken)) {
      found.message = why->message;
      found.cure = why->cure;
    }
    taken = taken || p >= 0;
  }
  if (model.blocks.empty()) found = {{}, "there are no bonds", "add a [[bonds]] block"};
  return found;
}

std::vector<std::string> own_values(const Model& model, const std::string& key) {
  const bool of_one = key.starts_with("bonds.");
  const std::string name = of_one ? key.substr(key.rfind('.') + 1) : key;
  std::vector<std::string> told;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    if (of_one && !key.starts_with(fmt::format("bonds.{}.", b))) continue;
    const Index p = find_bond_law(model.blocks[b].law)->find(name);
    const auto own = p < 0 ? model.blocks[b].overrides.end() : model.blocks[b].overrides.find(std::size_t(p));
    if (own == model.blocks[b].overrides.end()) continue;
    const std::vector<double>& values = own->second;
    const auto count = std::count_if(values.begin(), values.end(), [](double v) { return !std::isnan(v); });
    if (count > 0)
      told.push_back(
          fmt::format("{} of {} bonds of bonds.{} have a {} of their own", count, values.size(), b, name));
  }
  return told;
}

const Parameter& parameter_at(const Model& model, const BlockParameter& place) {
  return find_bond_law(model.blocks[std::size_t(place.block)].law)->parameters[place.parameter];
}

double value_at(const Model& model, const BlockParameter& place) {
  return model.blocks[std::size_t(place.block)].parameters[place.parameter];
}

std::string key_of(const Model& model, const BlockParameter& place) {
  return fmt::format("bonds.{}.{}", place.block, parameter_at(model, place).name);
}

}  // namespace bondstatic
