#include "statics/held.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/mechanism.hpp"

namespace bondstatic {

namespace {

// A body that nothing holds is left out as a whole: its particles get no unknowns.
void drop_unsupported(const Model& model, const BondNetwork& network, Held& held) {
  held.dropped = unsupported_bodies(network, held.dofs);
  std::vector<std::uint8_t> free = held.dofs.free;
  for (const auto& body : held.dropped) {
    for (const Index p : body) {
      held.left_out[std::size_t(p)] = true;
      free[std::size_t(p)] = 0;
    }
  }
  if (std::find(held.left_out.begin(), held.left_out.end(), false) == held.left_out.end())
    throw MechanismError(model, find_mechanisms(model, network, held.dofs, {}));
  held.dofs = number_free_dofs(std::move(free));
}

}  // namespace

Held held_by(const Model& model, const BondNetwork& network, std::vector<std::uint8_t> free,
             Unsupported unsupported) {
  Held held;
  held.left_out.assign(free.size(), false);
  held.dofs = number_free_dofs(std::move(free));
  if (unsupported == Unsupported::drop) drop_unsupported(model, network, held);
  auto mechanisms = find_mechanisms(model, network, held.dofs, held.left_out);
  if (!mechanisms.empty()) throw MechanismError(model, std::move(mechanisms));
  return held;
}

std::string lost_loads(const Model& model, const Held& held, const Boundary& boundary,
                       const std::string& load_case) {
  Vector3 lost = Vector3::Zero();
  Index particles = 0;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    if (!held.left_out[p] || boundary.load[p].isZero(0)) continue;
    lost += boundary.load[p].head<3>();
    ++particles;
  }
  if (particles == 0) return "";
  const std::string where = load_case.empty() ? "" : " of load case \"" + load_case + "\"";
  return fmt::format("loads{} on {} dropped particles are not carried, force ({:.6g}, {:.6g}, {:.6g}) in all",
                     where, particles, lost.x(), lost.y(), lost.z());
}

}  // namespace bondstatic
