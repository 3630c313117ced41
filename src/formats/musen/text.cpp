#include "formats/musen/text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "bond/codes.hpp"
#include "formats/musen/object.hpp"
#include "formats/musen/scene.hpp"
#include "formats/particle_ids.hpp"
#include "io/table_rows.hpp"

namespace bondstatic {
namespace {

double property(const MusenScene& scene, int material, Index number) {
  if (material < 0) return not_given;
  const auto found = scene.materials.find(scene.material_keys[std::size_t(material)]);
  if (found == scene.materials.end()) return not_given;
  const auto value = found->second.property.find(number);
  return value == found->second.property.end() ? not_given : value->second;
}

std::vector<std::string> group_names(const MusenScene& scene) {
  std::vector<std::string> names;
  for (const std::string& key : scene.material_keys) {
    const auto material = scene.materials.find(key);
    const bool named = material != scene.materials.end() && !material->second.name.empty();
    names.push_back(named ? material->second.name : key);
  }
  names.push_back("no material");
  return names;
}

void take_spheres(const MusenScene& scene, const std::string& path, ForeignModel& model,
                  std::vector<Fault>& faults) {
  std::vector<Index> ids;
  for (const MusenSphere& sphere : scene.spheres) {
    Particle particle{sphere.id, sphere.position, sphere.radius};
    const double density = property(scene, sphere.material, musen_property::density);
    if (density > 0) particle.density = density;
    model.particles.push_back(particle);
    model.particle_line.push_back(sphere.line);
    ids.push_back(sphere.id);
    model.group.push_back(sphere.material < 0 ? int(scene.material_keys.size()) : sphere.material);
  }
  model.group_names = group_names(scene);
  table_of_ids("particle", ids, model.particle_line, path, faults);
}

void take_bonds(const MusenScene& scene, ForeignModel& model) {
  const std::size_t count = scene.bonds.size();
  std::map<std::string, std::vector<double>> stiffness, strength;
  for (const char* name : {"kn", "ks", "kt", "kb"}) stiffness[name].resize(count, not_given);
  for (const char* name : {"normal_strength", "tangential_strength"}) strength[name].resize(count, not_given);
  std::vector<double> radius(count);
  const BondCode& elastic = *find_bond_code("musen-solid-bond");
  bool all_known = true;
  for (std::size_t i = 0; i < count; ++i) {
    const MusenBond& bond = scene.bonds[i];
    model.bonds.push_back({bond.id, bond.a, bond.b, bond.material < 0 ? -1 : bond.material + 1});
    model.bond_line.push_back(bond.line);
    radius[i] = bond.diameter / 2;
    const double young = property(scene, bond.material, musen_property::young);
    const double poisson = property(scene, bond.material, musen_property::poisson);
    const SectionStiffness c =
        elastic.realised({.length = bond.length}, std::array{bond.diameter, young, poisson}).stiffness;
    stiffness["kn"][i] = c.kn;
    stiffness["ks"][i] = c.ks;
    stiffness["kt"][i] = c.kt;
    stiffness["kb"][i] = c.kb;
    all_known &= std::isfinite(c.kn) && std::isfinite(c.ks);
    strength["normal_strength"][i] = property(scene, bond.material, musen_property::normal_strength);
    strength["tangential_strength"][i] = property(scene, bond.material, musen_property::tangential_strength);
  }
  if (count == 0) return;
  model.bond_columns["radius"] = std::move(radius);
  model.bond_columns["contact_point"].assign(count, 0.5);
  if (!all_known) {
    model.notes.left_out.push_back(
        "Stiffness of bonds: the file has no materials with Young's modulus and Poisson's ratio for them "
        "all. "
        "Export the compounds, too, or choose a law in [[bonds]]; MUSEN's elastic bond is kn = E A / L, "
        "ks = G A / L, kt = 2 G I / L, kb = E I / L.");
    return;
  }
  model.bond_columns.merge(stiffness);
  model.kept_columns = std::move(strength);
  model.notes.taken.push_back(
      "kn, ks, kt, kb are those of MUSEN's elastic solid bond, from its diameter, first length, Young's "
      "modulus "
      "and Poisson's ratio; it acts in the middle between the centres.");
  model.notes.assumed.push_back(
      "The file does not say which bond model the run has: its elastic one is taken, and bonds are free of "
      "stress "
      "in the positions of the file.");
  model.notes.left_out.push_back("Kept, not used by a static solve: normal_strength, tangential_strength.");
}

void check_ends(const MusenScene& scene, const std::string& path, std::vector<Fault>& faults) {
  IdTable ids;
  ids.expect(Index(scene.spheres.size()));
  for (const MusenSphere& sphere : scene.spheres) ids.add(sphere.id, 0);
  LimitedFaults limited(faults);
  for (const MusenBond& bond : scene.bonds) {
    const bool known = ids.position_of(bond.a) && ids.position_of(bond.b);
    if (known && bond.a != bond.b) continue;
    const std::string what =
        known ? "joins a sphere to itself" : "joins a sphere that is not there or not active";
    if (!limited.add({path, bond.line, 1},
                     fmt::format("bond {} between {} and {} {}", bond.id, bond.a, bond.b, what),
                     "export all spheres of the scene, at a time at which they are active"))
      return;
  }
}

void note_what_is_left(const MusenScene& scene, ImportNotes& notes) {
  if (scene.inactive > 0)
    notes.left_out.push_back(
        fmt::format("{} spheres and bonds that are not active at time {}, such as broken bonds.",
                    scene.inactive, scene.time));
  for (const auto& [what, count] : scene.left) notes.left_out.push_back(fmt::format("{}: {}.", what, count));
}

}  // namespace

std::optional<ForeignModel> read_musen_text(const std::string& path, const ReadOptions& options,
                                            const Place& named_at, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  const auto scene = read_musen_scene(path, options, named_at, faults);
  if (!scene) return std::nullopt;
  ForeignModel model;
  model.format = "MUSEN text export";
  model.si = true;
  model.cell = scene->cell;
  model.notes.taken.push_back(
      fmt::format("{} spheres and {} solid bonds at time {}, of {} time points; all is SI.",
                  scene->spheres.size(), scene->bonds.size(), scene->time, scene->times));
  if (options.particles) take_spheres(*scene, path, model, faults);
  check_ends(*scene, path, faults);
  if (options.bonds) take_bonds(*scene, model);
  if (faults.size() != before) return std::nullopt;
  if (!scene->sphere_keys.test(musen_key::activity))
    model.notes.assumed.push_back(
        "The file has no activity intervals: bonds that broke before this time cannot be told from sound "
        "ones.");
  note_what_is_left(*scene, model.notes);
  return model;
}

std::optional<ParticleState> read_musen_state(const std::string& path, const ReadOptions& options,
                                              const Place& named_at, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  const auto scene = read_musen_scene(path, options, named_at, faults);
  if (!scene) return std::nullopt;
  ParticleState state;
  state.step = options.step.value_or(scene->times);
  state.time = scene->time;
  state.cell = scene->cell;
  const auto has = [&](int key) { return scene->sphere_keys.test(std::size_t(key)); };
  const bool turned =
      has(musen_key::orientation) && scene->times > 1 && scene->orientations_followed.value_or(false);
  std::vector<int> line;
  for (const MusenSphere& sphere : scene->spheres) {
    state.id.push_back(sphere.id);
    line.push_back(sphere.line);
    state.position.push_back(sphere.position);
    state.radius.push_back(sphere.radius);
    state.type.push_back(sphere.material + 1);
    if (turned) state.orientation.push_back(sphere.turned);
    if (has(musen_key::velocity)) state.velocity.push_back(sphere.velocity);
    if (has(musen_key::angular_velocity)) state.angular_velocity.push_back(sphere.angular_velocity);
    if (has(musen_key::force)) state.force.push_back(sphere.force);
  }
  table_of_ids("particle", state.id, line, path, faults);
  if (faults.size() != before) return std::nullopt;
  return state;
}

}  // namespace bondstatic
