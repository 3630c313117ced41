#include "case/bonds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "case/bond_file.hpp"
#include "case/bond_parameters.hpp"
#include "case/bond_strength.hpp"
#include "case/selector.hpp"
#include "io/first_touch.hpp"
#include "io/pair_set.hpp"
#include "model/bond_formation.hpp"

namespace bondstatic {
namespace {

ContactPoint read_contact_point(TableReader& block) {
  Node* node = block.find("contact_point");
  if (!node) return {};
  if (node->is_number()) {
    const auto value = block.number("contact_point", dimension::none);
    if (value && *value > 0 && *value < 1) return {ContactPoint::Kind::fraction, *value};
    if (value)
      block.reading().fault(node->place, fmt::format("contact_point = {} must lie between 0 and 1", *value),
                            "give the part of the branch from particle a, e.g. 0.5");
    return {};
  }
  const std::string name =
      block.choice_or("contact_point", "gap", std::vector<std::string>{"gap", "beam", "contact-radii"});
  if (name == "gap") return {ContactPoint::Kind::gap, 0};
  if (name == "beam") return {ContactPoint::Kind::beam, 0};
  block.require("contact_radius_factor",
                "add contact_radius_factor = F: contact radii are F times the radii");
  return {ContactPoint::Kind::contact_radii,
          block.number("contact_radius_factor", dimension::none, Allowed::positive).value_or(1)};
}

/// Gap, contact radius factor or file; the factor may stand beside the others where the contact point needs
/// it. Bonds that are listed form by none of them.
Formation read_formation(TableReader& block, const ContactPoint& contact_point, bool listed,
                         bool& from_file) {
  std::vector<std::string> ways{"gap", "contact_radius_factor", "file"};
  const bool factor_is_taken = contact_point.kind == ContactPoint::Kind::contact_radii &&
                               (listed || block.has("gap") || block.has("file"));
  if (factor_is_taken) ways.erase(ways.begin() + 1);
  const std::string way = block.at_most_one_of(ways);
  from_file = way == "file";
  Formation formation;
  const auto gap = block.number("gap", dimension::length);
  const auto factor = block.number("contact_radius_factor", dimension::none, Allowed::positive);
  if (way == "contact_radius_factor") formation.contact_radius_factor = factor.value_or(1);
  if (way == "gap") formation.gap = gap.value_or(0);
  if (way.empty()) block.set_default("gap", Node::of(0.0));
  return formation;
}

std::optional<PositionLists> read_between(Draft& draft, TableReader& block, bool from_file) {
  const auto names = block.texts("between");
  if (!names) return std::nullopt;
  const Place& place = block.place_of("between");
  if (from_file)
    draft.reading.fault(place, "between and file exclude each other",
                        "list in the file what shall be bonded");
  if (names->empty() || names->size() > 2) {
    draft.reading.fault(place, fmt::format("between names {} groups", names->size()),
                        "write between = [\"a\", \"b\"], or one group for bonds inside it");
    return std::nullopt;
  }
  const auto* first = find_group(draft, names->front(), place);
  const auto* second = names->size() == 1 ? first : find_group(draft, names->back(), place);
  if (!first || !second) return std::nullopt;
  return PositionLists{*first, *second};
}

/// Adds the block's bonds to the model.
class BondAdder {
 public:
  /// `expected`: how many bonds the block asks for; `pairs_differ`: none of them twice.
  BondAdder(Draft& draft, std::string existing, int most_faults, std::size_t expected, bool pairs_differ)
      : draft_(draft),
        existing_(std::move(existing)),
        faults_(draft.reading.faults.size()),
        most_faults_(most_faults) {
    std::vector<Bond>& bonds = draft.model.bonds;
    for (const Bond& bond : bonds) next_id_ = std::max(next_id_, bond.id + 1);
    if (!pairs_differ || !bonds.empty()) {
      pairs_.emplace(Index(draft.model.particles.size()), Index(bonds.size() + expected));
      for (const Bond& bond : bonds) pairs_->add(bond.a, bond.b);
    }
    bonds.reserve(bonds.size() + expected);
    touch_pages(bonds.data() + bonds.size(), expected * sizeof(Bond), draft.reading.threads);
    draft.bond_of_id.expect(Index(expected));
  }

  /// `id` -1: the next one; `place()`: where it is asked for. `image`: of b, in a periodic cell; null: the
  /// nearest. False where the bond is left out.
  template <class PlaceOf>
  bool add(Index a, Index b, Index id, PlaceOf place, const CellImage* image = nullptr) {
    if (pairs_ && !pairs_->add(a, b) && existing_ != "add") {
      if (existing_ == "error")
        fault(place(), fmt::format("particles {} and {} are bonded already", id_of(a), id_of(b)),
              "write existing = \"skip\" to leave such pairs alone, or \"add\" for parallel bonds");
      return false;
    }
    Vector3 branch =
        draft_.model.particles[std::size_t(b)].position - draft_.model.particles[std::size_t(a)].position;
    if (draft_.model.cell)
      branch += shift_of(*draft_.model.cell, image ? *image : nearest(a, b, branch, place));
    if (a == b)
      fault(place(), fmt::format("particle {} would be bonded to its own image", id_of(a)),
            "the cell is too small for its bonds: repeat it along that edge");
    else if (branch.isZero(0))
      fault(place(), fmt::format("particles {} and {}, to be bonded, lie in one point", id_of(a), id_of(b)),
            "move or remove one of them");
    if (id < 0) id = next_id_;
    next_id_ = std::max(next_id_, id + 1);
    if (!draft_.bond_of_id.add(id, Index(draft_.model.bonds.size())))
      fault(place(), fmt::format("bond id {} is there twice", id), "give every bond an id of its own");
    draft_.model.bonds.push_back({id, a, b, branch, Index(draft_.model.blocks.size()), added_++});
    return true;
  }

  /// Begins to bring what such a bond needs, which lies anywhere in memory.
  ALWAYS_INLINE void fetch(Index a, Index b, Index id) const {
    for (const Index p : {a, b}) bondstatic::fetch(&draft_.model.particles[std::size_t(p)].position);
    if (pairs_) pairs_->fetch(a, b);
    draft_.bond_of_id.fetch(id);
  }

  Index added() const { return added_; }
  bool sound() const { return draft_.reading.faults.size() == faults_; }

 private:
  Index id_of(Index particle) const { return draft_.model.particles[std::size_t(particle)].id; }

  template <class PlaceOf>
  CellImage nearest(Index a, Index b, const Vector3& branch, PlaceOf place) {
    constexpr double doubt = 1e-6;
    const NearestImage found = nearest_image(*draft_.model.cell, branch);
    if (found.next_length <= (1 + doubt) * found.length)
      fault(place(),
            fmt::format(
                "two images of particle {} are equally near to particle {}, to which it is to be bonded",
                id_of(b), id_of(a)),
            "the cell is too small to tell which bond is meant: repeat it, or let bonds form by distance");
    return found.image;
  }

  void fault(const Place& place, const std::string& message, const std::string& cure) {
    if (++said_[cure] <= most_faults_) draft_.reading.fault(place, message, cure);
  }

  Draft& draft_;
  std::string existing_;
  std::size_t faults_;
  std::optional<PairSet> pairs_;  ///< absent where no pair can be there already
  Index next_id_ = 1;
  Index added_ = 0;
  int most_faults_;
  std::map<std::string, int> said_;  ///< of each kind, which its cure tells
};

/// Bonds that would go round the cell many times, each particle bonded to all others over and over, are a
/// slip of units.
bool cell_is_large_enough(Draft& draft, TableReader& block, const Formation& formation,
                          const PositionLists* lists) {
  constexpr double most_rounds = 4;
  const Cell& cell = *draft.model.cell;
  const double longest = longest_bond(draft.model.particles, formation, lists);
  for (int edge = 0; edge < 3; ++edge) {
    const double across = height(cell, edge);
    if (!cell.periodic[std::size_t(edge)] || longest <= most_rounds * across) continue;
    draft.reading.fault(
        block.place(),
        fmt::format("bonds could be {:.6g} long, {:.3g} times the cell's {:.6g} along edge {}", longest,
                    longest / across, across, "xyz"[edge]),
        "check the units of [cell], radii and gap; the cell should hold several particles "
        "along each periodic edge");
    return false;
  }
  return true;
}

/// Of rows that are listed, those with one end in each group.
void keep_between(const PositionLists& groups, BondRows& rows) {
  const auto has = [](const std::vector<Index>& group, Index particle) {
    return std::binary_search(group.begin(), group.end(), particle);
  };
  std::vector<Index> kept;
  for (std::size_t row = 0; row < rows.a.size(); ++row) {
    const Index a = rows.a[row], b = rows.b[row];
    if ((has(groups.first, a) && has(groups.second, b)) || (has(groups.first, b) && has(groups.second, a)))
      kept.push_back(Index(row));
  }
  const auto keep = [&](auto& values) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[std::size_t(kept[i])];
    values.resize(kept.size());
  };
  keep(rows.a);
  keep(rows.b);
  keep(rows.ids);
  keep(rows.fractions);
  for (auto* columns : {&rows.overrides, &rows.strengths})
    for (auto& column : *columns) keep(column.second);
  if (!rows.places.empty()) rows.places.keep(kept);
}

/// Bonds of the rows that were not skipped, with their own parameters.
void add_rows(BondAdder& adder, const BondRows& rows, BondBlock& made) {
  const auto id_of = [&](std::size_t row) { return rows.ids.empty() ? -1 : rows.ids[row]; };
  constexpr std::size_t ahead = 32;
  for (std::size_t row = 0; row < rows.a.size(); ++row) {
    if (const std::size_t next = row + ahead; next < rows.a.size())
      adder.fetch(rows.a[next], rows.b[next], id_of(next));
    const Index id = id_of(row);
    if (!adder.add(rows.a[row], rows.b[row], id, [&] { return rows.places[row]; })) continue;
    for (const auto& [parameter, values] : rows.overrides) made.overrides[parameter].push_back(values[row]);
    for (const auto& [strength, values] : rows.strengths)
      made.strength->overrides[strength].push_back(values[row]);
    if (!rows.fractions.empty()) made.fractions.push_back(rows.fractions[row]);
  }
}

}  // namespace

void read_bond_block(Draft& draft, TableReader& block, const ListedBonds* listed) {
  Reading& reading = draft.reading;
  const std::size_t before = reading.faults.size();
  auto file = block.has("file") ? open_bond_file(draft, block) : std::nullopt;
  const bool stiffness_given = listed ? listed->gives_stiffness : file && file->gives_stiffness();
  const BondLaw* law = read_law(block, stiffness_given ? "generic" : "");
  BondBlock made;
  std::vector<double> given;
  if (law) {
    made.law = law->name;
    given = read_parameters(block, *law);
  }
  const bool parameters_read = reading.faults.size() == before;
  made.contact_point = read_contact_point(block);
  bool from_file = false;
  const Formation formation = read_formation(block, made.contact_point, listed != nullptr, from_file);
  const auto between = read_between(draft, block, from_file);
  auto strengths = read_strength(block);
  const std::string existing =
      block.choice_or("existing", "error", std::vector<std::string>{"error", "add", "skip"});
  if (!law) return block.accept_any();  // its parameters are unknown

  std::optional<BondRows> rows;
  if (listed)
    rows = listed->rows(*law, given, strengths ? &*strengths : nullptr);
  else if (from_file && file)
    rows = bond_rows(draft, std::move(*file), *law, given, strengths ? &*strengths : nullptr);
  if (listed && rows && between) keep_between(*between, *rows);
  if (strengths && (rows || !(from_file || listed))) {
    check_strength(block, *strengths, *law, given, rows ? &*rows : nullptr);
    made.strength = std::move(strengths->made);
  }
  if (rows && !rows->overrides.empty())
    made.parameters = given;  // each bond completes them in its own way
  else if (parameters_read && (rows || !(from_file || listed)))
    made.parameters = complete_parameters(block, *law, given);
  if (reading.faults.size() != before || !draft.particles_known) return;

  std::vector<std::pair<Index, Index>> formed;
  std::vector<BondedImage> across;
  const PositionLists* lists = between ? &*between : nullptr;
  if (listed && !rows) return;
  if (!rows && draft.model.cell && !cell_is_large_enough(draft, block, formation, lists)) return;
  if (!rows && draft.model.cell)
    across = bonded_images(draft.model.particles, *draft.model.cell, formation, lists, reading.threads);
  else if (!rows)
    formed = bonded_pairs(draft.model.particles, formation, lists, reading.threads);
  const int most_faults = rows ? 20 : 1;  // formed bonds share the place of their block
  BondAdder adder(draft, existing, most_faults, rows ? rows->a.size() : formed.size() + across.size(), !rows);
  if (rows) add_rows(adder, *rows, made);
  const auto place = [&] { return block.place(); };
  for (const auto& [a, b] : formed) adder.add(a, b, -1, place);
  for (const BondedImage& bond : across) adder.add(bond.a, bond.b, -1, place, &bond.image);
  if (adder.sound() && adder.added() == 0) {
    if (existing == "skip")
      reading.warnings.push_back(
          fmt::format("{}:{}: the block forms no bond", block.place().file, block.place().line));
    else
      reading.fault(block.place(), "the block forms no bond",
                    "no two particles are near enough: raise gap or contact_radius_factor, or check radii "
                    "and positions");
  }
  draft.model.blocks.push_back(std::move(made));
}

void read_bonds(Draft& draft, Node* list) {
  for_each_table(draft.reading, list, "bonds", [&](TableReader& block) {
    const std::size_t before = draft.reading.faults.size();
    read_bond_block(draft, block, nullptr);
    if (draft.reading.faults.size() != before) draft.bonds_known = false;
  });
}

}  // namespace bondstatic
