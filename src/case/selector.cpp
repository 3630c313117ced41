#include "case/selector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "case/box_reader.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

using Test = std::function<bool(const Particle&)>;

// Lattice positions such as 3 x 0.1 carry rounding: a centre on the boundary is inside.
constexpr double tolerance = 1e-9;

/// Positions of the ids that a node lists, ascending. `what` is "particle" or "bond".
std::vector<Index> positions_of_ids(Reading& reading, const Node& node, const std::string& key,
                                    const char* what, const IdTable& table, bool known) {
  std::vector<Index> positions;
  const auto add = [&](const Node& item) {
    const auto id = read_whole(reading, item, key, 0);
    if (!id || !known) return;
    const Index* found = table.position_of(*id);
    if (!found)
      reading.fault(item.place, fmt::format("there is no {} {}", what, *id),
                    fmt::format("the model has {} {}s; check the id", table.size(), what));
    else
      positions.push_back(*found);
  };
  if (node.is_array())
    for (const Node& item : node.items) add(item);
  else
    add(node);
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

/// What one selector has narrowed the particles down to.
struct Selection {
  std::vector<char> chosen;

  void keep(const std::vector<Index>& positions) {
    std::vector<char> listed(chosen.size());
    for (const Index p : positions) listed[std::size_t(p)] = chosen[std::size_t(p)];
    chosen = std::move(listed);
  }
  void keep(const std::vector<Particle>& particles, const Test& test) {
    for (std::size_t p = 0; p < chosen.size(); ++p) chosen[p] = chosen[p] && test(particles[p]);
  }
  std::vector<Index> positions() const {
    std::vector<Index> list;
    for (std::size_t p = 0; p < chosen.size(); ++p)
      if (chosen[p]) list.push_back(Index(p));
    return list;
  }
};

std::optional<Test> sphere_test(TableReader reader) {
  reader.require("centre", "add centre = [X, Y, Z]");
  reader.require("radius", "add radius = R");
  const auto centre = reader.vector("centre", dimension::length);
  const auto radius = reader.number("radius", dimension::length, Allowed::positive);
  reader.finish();
  if (!centre || !radius) return std::nullopt;
  return [c = *centre, r = *radius](const Particle& p) {
    return (p.position - c).norm() <= r + tolerance * p.radius;
  };
}

std::optional<Test> plane_test(TableReader reader) {
  reader.require("point", "add point = [X, Y, Z], any point of the plane");
  reader.require("normal", "add normal = \"x\", \"y\", \"z\" or [X, Y, Z], pointing to the side meant");
  const auto point = reader.vector("point", dimension::length);
  const auto normal = reader.axis("normal");
  reader.finish();
  if (!point || !normal) return std::nullopt;
  return
      [x = *point, n = *normal](const Particle& p) { return n.dot(p.position - x) >= -tolerance * p.radius; };
}

/// `sign` -1 for lowest, +1 for highest.
std::optional<Test> extreme_test(TableReader reader, const std::vector<Particle>& particles, double sign) {
  const Vector3 axis = sign * reader.axis_or("axis", "z");
  reader.require("within", "add within = D, the largest distance from the outermost centre along the axis");
  const auto within = reader.number("within", dimension::length, Allowed::not_negative);
  reader.finish();
  if (!within) return std::nullopt;
  double outermost = -std::numeric_limits<double>::infinity();
  for (const Particle& p : particles) outermost = std::max(outermost, axis.dot(p.position));
  return [=, d = *within](const Particle& p) {
    return axis.dot(p.position) >= outermost - d - tolerance * p.radius;
  };
}

void apply_geometry(Draft& draft, TableReader& selector, Selection& selection) {
  const std::vector<Particle>& particles = draft.model.particles;
  const auto apply = [&](const std::string& key,
                         const std::function<std::optional<Test>(TableReader)>& make) {
    Node* node = selector.find(key);
    if (!node) return;
    if (const auto test = make(TableReader(draft.reading, *node, key))) selection.keep(particles, *test);
  };
  apply("box", box_test);
  apply("sphere", sphere_test);
  apply("plane", plane_test);
  apply("lowest", [&](TableReader reader) { return extreme_test(std::move(reader), particles, -1); });
  apply("highest", [&](TableReader reader) { return extreme_test(std::move(reader), particles, 1); });
}

/// `all = true`; all = false would select nothing and is a slip.
bool read_all(TableReader& selector) {
  const Node* all = selector.find("all");
  if (!all) return false;
  const auto truth = read_truth(selector.reading(), *all, "all");
  if (truth && !*truth)
    selector.reading().fault(all->place, "all = false selects nothing", "leave it out and say what is meant");
  return true;
}

bool need_a_key(TableReader& selector, const Node& node, const std::vector<std::string>& keys) {
  for (const std::string& key : keys)
    if (selector.has(key)) return true;
  if (node.is_table() && node.items.empty())
    selector.reading().fault(node.place, fmt::format("{} is empty", selector.name()),
                             fmt::format("give one or more of: {}", name_list(keys)));
  return false;
}

}  // namespace

std::optional<std::vector<Index>> select_particles(Draft& draft, TableReader& owner, const std::string& key) {
  Reading& reading = draft.reading;
  const std::size_t before = reading.faults.size();
  if (!owner.require(
          key,
          fmt::format("add {} = {{ id = [..] }}, or group, box, sphere, plane, lowest, highest, all", key)))
    return std::nullopt;
  Node& node = *owner.find(key);
  TableReader selector(reading, node, key);
  need_a_key(selector, node, {"id", "group", "box", "sphere", "plane", "lowest", "highest", "all"});

  Selection selection{std::vector<char>(draft.model.particles.size(), 1)};
  if (const Node* ids = selector.find("id"))
    selection.keep(
        positions_of_ids(reading, *ids, "id", "particle", draft.particle_of_id, draft.particles_known));
  if (const auto names = selector.texts("group")) {
    std::vector<Index> members;
    for (const std::string& name : *names)
      if (const std::vector<Index>* group = find_group(draft, name, selector.place_of("group")))
        members.insert(members.end(), group->begin(), group->end());
    selection.keep(members);
  }
  apply_geometry(draft, selector, selection);
  read_all(selector);
  selector.finish();

  std::vector<Index> positions = selection.positions();
  if (reading.faults.size() != before || !draft.particles_known) return std::nullopt;
  if (!positions.empty()) return positions;
  reading.fault(node.place, fmt::format("{} selects no particle", key),
                "check the selector against the particles' centres; several keys in one selector intersect");
  return std::nullopt;
}

std::optional<std::vector<Index>> select_bonds(Draft& draft, TableReader& owner, const std::string& key) {
  Reading& reading = draft.reading;
  const std::size_t before = reading.faults.size();
  if (!owner.require(key, fmt::format("add {0} = {{ bond = [..] }} or {0} = {{ all = true }}", key)))
    return std::nullopt;
  Node& node = *owner.find(key);
  TableReader selector(reading, node, key + " of a bond quantity");
  need_a_key(selector, node, {"bond", "all"});
  const bool known = draft.bonds_known && draft.particles_known;

  std::vector<Index> positions;
  if (const Node* ids = selector.find("bond"))
    positions = positions_of_ids(reading, *ids, "bond", "bond", draft.bond_of_id, known);
  else if (read_all(selector))
    for (Index b = 0; b < Index(draft.model.bonds.size()); ++b) positions.push_back(b);
  selector.has("all");
  selector.finish();
  if (reading.faults.size() != before || !known) return std::nullopt;
  if (!positions.empty()) return positions;
  reading.fault(node.place, fmt::format("{} selects no bond", key), "give ids of bonds, or all = true");
  return std::nullopt;
}

const std::vector<Index>* find_group(Draft& draft, const std::string& name, const Place& place) {
  const auto found = draft.groups.find(name);
  if (found != draft.groups.end()) return &found->second;
  if (!draft.particles_known) return nullptr;
  std::vector<std::string> names;
  for (const auto& group : draft.groups) names.push_back(group.first);
  const std::string nearest = nearest_name(name, names);
  draft.reading.fault(place, fmt::format("there is no group \"{}\"", name),
                      !nearest.empty() ? fmt::format("did you mean \"{}\"?", nearest)
                      : names.empty()  ? "name one with group = \"..\" in [[particles]], or in [[groups]]"
                                       : fmt::format("there are: {}", name_list(names)));
  return nullptr;
}

void read_groups(Draft& draft, Node* list) {
  for_each_table(draft.reading, list, "groups", [&](TableReader& block) {
    block.require("name", "add name = \"..\"");
    const auto name = block.text("name");
    const auto members = select_particles(draft, block, "at");
    if (!name) return;
    if (name->empty())
      draft.reading.fault(block.place_of("name"), "a group's name must not be empty",
                          "name it, e.g. \"top\"");
    else if (draft.groups.count(*name))
      draft.reading.fault(block.place_of("name"), fmt::format("there is a group \"{}\" already", *name),
                          "choose another name");
    else
      draft.groups[*name] = members.value_or(std::vector<Index>{});
  });
}

}  // namespace bondstatic
