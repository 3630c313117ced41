// A libFuzzer target: the first byte chooses a reader of foreign files, or of results that may have been
// edited, the rest is the file. Whatever a file holds, a reader must answer a sound result or faults that a
// user can act on; never both, never neither.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <functional>
#include <unordered_set>

#include "demand.hpp"
#include "formats/lammps/data.hpp"
#include "formats/lammps/dump.hpp"
#include "formats/lammps/local.hpp"
#include "formats/lammps/script.hpp"
#include "results.hpp"

namespace bondstatic {
namespace {

const Place named_at{"case.toml", 1, 1};

/// Whether bonds join two particles, and which, is not looked at before all files are joined
/// (join_models.hpp).
void check(const ForeignModel& model) {
  std::unordered_set<Index> ids;
  for (const Particle& p : model.particles) {
    demand(p.id == -1 || (p.id >= 0 && ids.insert(p.id).second), "ids are distinct");
    demand(p.position.allFinite(), "positions are finite");
    demand(std::isnan(p.radius) || (p.radius > 0 && std::isfinite(p.radius)), "radii are positive");
  }
  demand(model.group.empty() || model.group.size() == model.particles.size(), "each particle has a group");
  demand(model.particle_line.empty() || model.particle_line.size() == model.particles.size(),
         "particle lines");
  demand(model.bond_line.empty() || model.bond_line.size() == model.bonds.size(), "bond lines");
  for (const auto* columns : {&model.bond_columns, &model.kept_columns})
    for (const auto& [name, values] : *columns)
      demand(values.size() == model.bonds.size(), "columns of bonds");
}

void check(const ParticleState& state) {
  demand(state.position.size() == state.id.size(), "each particle has a position");
  demand(std::unordered_set<Index>(state.id.begin(), state.id.end()).size() == state.id.size(),
         "ids are distinct");
  for (const Vector3& x : state.position) demand(x.allFinite(), "positions are finite");
  demand(state.orientation.empty() || state.orientation.size() == state.id.size(), "orientations");
  for (const auto& q : state.orientation) demand(std::abs(q.norm() - 1) < 1e-9, "quaternions have norm one");
}

void check(const BondState& state) {
  demand(state.a.size() == state.b.size(), "each bond has two particles");
  for (const auto& [name, values] : state.columns)
    demand(values.size() == state.a.size(), "columns of bonds");
}

void check(const std::vector<Index>& steps) {
  for (const Index step : steps) demand(step >= 0, "steps are not negative");
}

void check(const LammpsScript&) {}

using Reader = std::function<void(const std::string& path, std::vector<Fault>& faults)>;

/// A reader, with the demands on what it answers.
template <class Read>
Reader demanding(Read read) {
  return [read](const std::string& path, std::vector<Fault>& faults) {
    const auto result = read(path, faults);
    demand(result.has_value() != !faults.empty(), "a result or faults");
    if (result) check(*result);
  };
}

Reader model_reader(std::optional<ForeignModel> (*read)(const std::string&, const ReadOptions&, const Place&,
                                                        std::vector<Fault>&),
                    const ReadOptions& options = {}) {
  return demanding([=](const std::string& path, std::vector<Fault>& faults) {
    return read(path, options, named_at, faults);
  });
}

ReadOptions with_columns() {
  ReadOptions options;
  options.bond_columns = {"c_bl[1]", "c_bl[2]", "c_bl[3]"};
  return options;
}

ReadOptions with_style() {
  ReadOptions options;
  options.atom_style = "hybrid sphere bond";
  return options;
}

const std::vector<Reader>& readers() {
  static const std::vector<Reader> all{
      model_reader(read_foreign_model),
      model_reader(read_lammps_data),
      model_reader(read_lammps_data, with_style()),
      model_reader(read_lammps_dump),
      model_reader(read_lammps_local, with_columns()),
      demanding(
          [](const auto& path, auto& faults) { return read_particle_state(path, {}, named_at, faults); }),
      demanding(
          [](const auto& path, auto& faults) { return read_lammps_dump_state(path, {}, named_at, faults); }),
      demanding([](const auto& path, auto& faults) {
        return read_bond_state(path, with_columns(), named_at, faults);
      }),
      demanding([](const auto& path, auto& faults) { return dump_steps(path, named_at, faults); }),
      demanding([](const auto& path, auto& faults) { return read_lammps_script(path, named_at, faults); }),
      read_whole_grid,
      read_whole_table,
      read_whole_sweep,
      read_whole_json,
  };
  return all;
}

}  // namespace
}  // namespace bondstatic

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bondstatic;
  if (size == 0) return 0;
  static const int file = ::memfd_create("input", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  demand(::ftruncate(file, 0) == 0, "an empty file");
  demand(::pwrite(file, data + 1, size - 1, 0) == ssize_t(size - 1), "a written file");
  std::vector<Fault> faults;
  readers()[data[0] % readers().size()](path, faults);
  for (const Fault& fault : faults)
    demand(
        !fault.place.file.empty() && fault.place.line >= 1 && !fault.message.empty() && !fault.cure.empty(),
        to_string(fault).c_str());
  return 0;
}
