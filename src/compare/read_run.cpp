#include "compare/read_run.hpp"

#include <fmt/format.h>

#include "formats/readers.hpp"

namespace bondstatic {

BondForceColumns bond_force_columns(const std::vector<std::string>& names) {
  BondForceColumns columns;
  if (names.empty()) return columns;
  if (names.size() != 3 && names.size() != 6)
    throw InputError({{{},
                       fmt::format("{} columns are named for the force of bonds", names.size()),
                       "give three for the force, or six for force and moment: FX,FY,FZ"}});
  for (std::size_t i = 0; i < names.size(); ++i) (i < 3 ? columns.force : columns.moment)[i % 3] = names[i];
  if (names.size() == 3) columns.moment = {};
  return columns;
}

RunState read_run(const Model& model, const State& statics, const std::string& file,
                  std::optional<Index> step) {
  ReadOptions options;
  options.step = step;
  std::vector<Fault> faults;
  const auto read = read_particle_state(file, options, {}, faults);
  if (!faults.empty() || !read) throw InputError(std::move(faults));
  auto run = match_particles(model, statics, *read, file, faults);
  if (!run) throw InputError(std::move(faults));
  return std::move(*run);
}

void read_bond_forces(const Model& model, const State& statics, const BondForceFile& bonds,
                      std::optional<Index> step, RunState& run) {
  ReadOptions options;
  options.step = step;
  options.bond_columns = bonds.ids;
  std::vector<Fault> faults;
  const auto read = read_bond_state(bonds.file, options, {}, faults);
  if (!faults.empty() || !read) throw InputError(std::move(faults));
  if (read->step != run.step)
    run.notes.push_back(
        fmt::format("The bonds are of step {}, the particles of step {}.", read->step, run.step));
  match_bonds(model, statics, *read, bonds.force, bonds.file, run, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace bondstatic
