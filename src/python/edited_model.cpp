#include "python/edited_model.hpp"

#include <algorithm>

#include "solver/machine.hpp"

namespace bondstatic {

EditedModel::EditedModel(Model model) : EditedModel() {
  draft_->model = std::move(model);
  draft_->particle_of_id.expect(Index(draft_->model.particles.size()));
  draft_->bond_of_id.expect(Index(draft_->model.bonds.size()));
  Index position = 0;
  for (const Particle& particle : draft_->model.particles)
    draft_->particle_of_id.add(particle.id, position++);
  position = 0;
  for (const Bond& bond : draft_->model.bonds) draft_->bond_of_id.add(bond.id, position++);
}

EditedModel::Extent EditedModel::begin(const std::string& caller) {
  if (draft_.use_count() > 1) draft_ = std::make_shared<Draft>(*draft_);
  draft_->reading.file = caller;
  draft_->reading.threads = cores_at_hand();
  const Model& m = draft_->model;
  Extent extent{
      m.blocks.size(), m.bonds.size(), m.supports.size(), m.loads.size(), m.strains.size(), m.load_cases, {}};
  for (const auto& group : draft_->groups) extent.groups.push_back(group.first);
  return extent;
}

void EditedModel::undo(const Extent& before) {
  Model& m = draft_->model;
  const bool bonds_came = m.bonds.size() != before.bonds;
  m.blocks.resize(before.blocks);
  m.bonds.resize(before.bonds);
  m.supports.resize(before.supports);
  m.loads.resize(before.loads);
  m.strains.resize(before.strains);
  m.load_cases = before.load_cases;
  std::erase_if(draft_->groups, [&](const auto& group) {
    return !std::binary_search(before.groups.begin(), before.groups.end(), group.first);
  });
  if (bonds_came) {
    draft_->bond_of_id = {};
    for (std::size_t k = 0; k < m.bonds.size(); ++k) draft_->bond_of_id.add(m.bonds[k].id, Index(k));
  }
  draft_->particles_known = draft_->bonds_known = true;
  draft_->reading.faults.clear();
  draft_->reading.warnings.clear();
}

std::vector<std::string> EditedModel::end(const Extent& before) {
  Reading& reading = draft_->reading;
  if (!reading.faults.empty()) {
    InputError error(reading.faults);
    undo(before);
    throw error;
  }
  return std::exchange(reading.warnings, {});
}

}  // namespace bondstatic
