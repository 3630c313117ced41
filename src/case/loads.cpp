#include "case/loads.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/cell.hpp"
#include "case/load_cases.hpp"
#include "case/selector.hpp"

namespace bondstatic {
namespace {

/// Force or moment on each of `count` particles; zero where the block has none.
Vector3 read_share(TableReader& block, const std::string& each, const std::string& total, Dimension dimension,
                   std::size_t count) {
  block.at_most_one_of(std::vector<std::string>{each, total});
  const auto on_each = block.vector(each, dimension), in_all = block.vector(total, dimension);
  if (on_each) return *on_each;
  return in_all && count > 0 ? Vector3(*in_all / double(count)) : Vector3(Vector3::Zero());
}

/// What gravity pulls: the selected ones, which must have a density, or without a selector all that have one.
std::vector<Index> heavy(Draft& draft, TableReader& block, const std::optional<std::vector<Index>>& at) {
  std::vector<Index> with_density;
  const auto& particles = draft.model.particles;
  for (std::size_t p = 0; p < particles.size(); ++p)
    if (!std::isnan(particles[p].density)) with_density.push_back(Index(p));
  if (!draft.particles_known) return {};
  if (block.has("at")) {
    for (const Index p : at.value_or(std::vector<Index>{})) {
      if (!std::isnan(particles[std::size_t(p)].density)) continue;
      draft.reading.fault(
          block.place_of("gravity"),
          fmt::format("gravity on particle {}, which has no density", particles[std::size_t(p)].id),
          "add density = RHO to its [[particles]] block");
      return {};
    }
    return at.value_or(std::vector<Index>{});
  }
  if (with_density.empty())
    draft.reading.fault(block.place_of("gravity"), "gravity, but no particle has a density",
                        "add density = RHO to [[particles]]");
  return with_density;
}

}  // namespace

void read_loads(Draft& draft, Node* list) {
  for_each_table(draft.reading, list, "loads", [&](TableReader& block) {
    const std::size_t before = draft.reading.faults.size();
    const auto gravity = block.vector("gravity", dimension::acceleration);
    std::optional<std::vector<Index>> at;
    const std::vector<std::string> point_keys{"force", "total_force", "moment", "total_moment"};
    bool has_point_load = false;
    for (const std::string& key : point_keys) has_point_load = block.has(key) || has_point_load;
    const auto strain = read_strain(draft, block);
    const bool on_all = block.has("gravity") || block.has("strain");
    if (!on_all || has_point_load || block.has("at")) at = select_particles(draft, block, "at");
    if (!on_all && !has_point_load)
      block.require("force", "add force = [X, Y, Z], total_force, moment, total_moment, gravity or strain");

    const std::size_t count = at ? at->size() : 0;
    Load load;
    load.force << read_share(block, "force", "total_force", dimension::force, count),
        read_share(block, "moment", "total_moment", dimension::moment, count);
    load.load_case = load_case_of(draft, block);
    const std::vector<Index> pulled = gravity ? heavy(draft, block, at) : std::vector<Index>{};
    if (draft.reading.faults.size() != before) return;

    const auto act = [&](Action::Kind kind) {
      draft.actions.push_back({kind, load.load_case, block.place()});
    };
    if (strain) draft.model.strains.push_back({*strain, load.load_case});
    if (strain && !strain->isZero(0)) act(Action::Kind::strain);
    if (!load.force.isZero(0) || (gravity && !gravity->isZero(0))) act(Action::Kind::force);
    if (at && has_point_load)
      for (const Index particle : *at) {
        load.particle = particle;
        draft.model.loads.push_back(load);
      }
    for (const Index particle : pulled) {
      const Particle& body = draft.model.particles[std::size_t(particle)];
      Load weight{particle, Vector6::Zero(), load.load_case};
      weight.force.head<3>() = mass(body) * *gravity;
      draft.model.loads.push_back(weight);
    }
  });
}

}  // namespace bondstatic
