#include "statics/held.hpp"

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

}  // namespace bondstatic
