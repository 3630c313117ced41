#include "formats/lammps/local.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/lammps/dump_steps.hpp"
#include "io/nearest_name.hpp"
#include "io/table_rows.hpp"

namespace bondstatic {
namespace {

/// Names that users give to the columns by dump_modify colname, after the attributes of compute
/// property/local of LAMMPS and pair/gran/local of LIGGGHTS.
constexpr std::array<std::array<const char*, 2>, 5> known_names{
    {{"batom1", "batom2"}, {"id1", "id2"}, {"atom1", "atom2"}, {"patom1", "patom2"}, {"a", "b"}}};
constexpr std::array known_types{"btype", "type"};

struct BondRows {
  DumpRows rows;
  std::array<int, 3> columns{-1, -1, -1};  ///< a, b, type in the header's columns
  std::vector<int> others;                 ///< in rows.values from the third or fourth on

  std::size_t others_begin() const { return columns[2] < 0 ? 2 : 3; }
};

int find(const DumpHeader& header, const std::string& name) {
  const auto found = std::find(header.columns.begin(), header.columns.end(), name);
  return found == header.columns.end() ? -1 : int(found - header.columns.begin());
}

/// From the options, or by well-known names.
bool choose_columns(const DumpHeader& header, const ReadOptions& options, const std::string& path,
                    const Place& named_at, BondRows& bonds, std::vector<Fault>& faults) {
  const auto& asked = options.bond_columns;
  const std::string names = name_list(header.columns);
  if (!asked.empty()) {
    if (asked.size() < 2 || asked.size() > 3) {
      faults.push_back({named_at, fmt::format("{} bond columns are named", asked.size()),
                        "name two, of the particles, or three, with the bond type"});
      return false;
    }
    for (std::size_t i = 0; i < asked.size(); ++i) {
      bonds.columns[i] = find(header, asked[i]);
      const bool again =
          std::find(asked.begin(), asked.begin() + long(i), asked[i]) != asked.begin() + long(i);
      if (bonds.columns[i] >= 0 && !again) continue;
      faults.push_back({{path, header.columns_line, 1},
                        again ? fmt::format("bond column \"{}\" is named twice", asked[i])
                              : fmt::format("no column \"{}\"", asked[i]),
                        "the columns are " + names});
      return false;
    }
    return true;
  }
  for (const auto& pair : known_names) {
    bonds.columns = {find(header, pair[0]), find(header, pair[1]), -1};
    if (bonds.columns[0] >= 0 && bonds.columns[1] >= 0) {
      for (const char* type : known_types)
        if (bonds.columns[2] < 0) bonds.columns[2] = find(header, type);
      return true;
    }
  }
  const bool enough = header.columns.size() > 2;
  faults.push_back({{path, header.columns_line, 1},
                    fmt::format("which of the columns {} hold the ids of a bond's particles?", names),
                    fmt::format("name them, for instance --bond-columns {},{}",
                                enough ? header.columns[header.columns.size() > 3 ? 1 : 0] : "A",
                                enough ? header.columns[header.columns.size() > 3 ? 2 : 1] : "B")});
  return false;
}

std::optional<BondRows> read_bonds(const std::string& path, const ReadOptions& options, bool all_columns,
                                   const Place& named_at, std::vector<Fault>& faults) {
  BondRows bonds;
  const auto choose = [&](const DumpHeader& header, std::vector<Fault>& wrong) {
    std::vector<WantedColumn> wanted;
    if (!choose_columns(header, options, path, named_at, bonds, wrong)) return wanted;
    for (const int column : bonds.columns)
      if (column >= 0) wanted.push_back({column, 0});
    for (int column = 0; column < int(header.columns.size()); ++column) {
      if (std::find(bonds.columns.begin(), bonds.columns.end(), column) != bonds.columns.end()) continue;
      bonds.others.push_back(column);
      if (all_columns) wanted.push_back({column, std::nullopt});
    }
    return wanted;
  };
  auto rows = read_dump_rows(path, options, choose, named_at, faults);
  if (!rows) return std::nullopt;
  bonds.rows = std::move(*rows);

  const std::size_t before = faults.size();
  LimitedFaults limited(faults);
  const auto &a = bonds.rows.values[0], &b = bonds.rows.values[1];
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] == b[i] &&
        !limited.add({path, bonds.rows.line[i], 1}, fmt::format("a bond of particle {} with itself", a[i]),
                     "see that --bond-columns names the columns of the two particles"))
      break;
  if (faults.size() != before) return std::nullopt;
  return bonds;
}

std::string about_the_bonds(const BondRows& bonds) {
  const DumpHeader& header = bonds.rows.header;
  std::string text = about_step(bonds.rows) + fmt::format(". Columns {} and {} are the bonds' particles",
                                                          header.columns[std::size_t(bonds.columns[0])],
                                                          header.columns[std::size_t(bonds.columns[1])]);
  if (bonds.columns[2] >= 0)
    text += fmt::format(", {} is their type", header.columns[std::size_t(bonds.columns[2])]);
  return text + ".";
}

}  // namespace

std::optional<BondState> read_lammps_local_state(const std::string& path, const ReadOptions& options,
                                                 const Place& named_at, std::vector<Fault>& faults) {
  auto bonds = read_bonds(path, options, true, named_at, faults);
  if (!bonds) return std::nullopt;
  BondState state;
  const DumpRows& rows = bonds->rows;
  state.step = rows.header.step;
  state.a.assign(rows.values[0].begin(), rows.values[0].end());
  state.b.assign(rows.values[1].begin(), rows.values[1].end());
  const auto keep = [&](int column, std::size_t slot) {
    state.columns[rows.header.columns[std::size_t(column)]] = std::move(bonds->rows.values[slot]);
  };
  if (bonds->columns[2] >= 0) keep(bonds->columns[2], 2);
  for (std::size_t i = 0; i < bonds->others.size(); ++i) keep(bonds->others[i], bonds->others_begin() + i);
  state.notes = {about_the_bonds(*bonds)};
  return state;
}

std::optional<ForeignModel> read_lammps_local(const std::string& path, const ReadOptions& options,
                                              const Place& named_at, std::vector<Fault>& faults) {
  auto bonds = read_bonds(path, options, false, named_at, faults);
  if (!bonds) return std::nullopt;
  ForeignModel model;
  model.format = format_name(FileFormat::lammps_local);
  const auto& values = bonds->rows.values;
  model.bonds.resize(bonds->rows.line.size());
  for (std::size_t i = 0; i < model.bonds.size(); ++i) {
    model.bonds[i].a = Index(values[0][i]);
    model.bonds[i].b = Index(values[1][i]);
    if (bonds->columns[2] >= 0) model.bonds[i].type = Index(values[2][i]);
  }
  model.bond_line = std::move(bonds->rows.line);
  model.si = bonds->rows.header.units == "si";
  model.notes.taken = {about_the_bonds(*bonds)};
  std::vector<std::string> unused;
  for (const int column : bonds->others) unused.push_back(bonds->rows.header.columns[std::size_t(column)]);
  if (!unused.empty())
    model.notes.left_out = {"Columns that a model has no use for: " + name_list(unused) + "."};
  return model;
}

}  // namespace bondstatic
