#include "statics/held.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bondstatic/mechanism.hpp"
#include "system/together.hpp"

namespace bondstatic {

namespace {

// A body that nothing holds is left out as a whole: its particles get no unknowns.
void drop_unsupported(const Model& model, const BondNetwork& network, Held& held) {
  std::vector<std::uint8_t> free = held.dofs.free;
  for (const auto& body : unsupported_bodies(network, held.dofs)) {
    held.dropped.emplace_back();
    for (const Index p : body) {
      held.dropped.back().push_back(model.particles[std::size_t(p)].id);
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

std::string lost_loads(const BondNetwork& network, const Held& held, const Boundary& boundary,
                       const std::string& load_case, Ranks* ranks) {
  std::array<Extended, 4> lost{0.0, 0.0, 0.0, 0.0};  // force, particles
  for (std::size_t p = 0; p < std::size_t(network.own()); ++p) {
    if (!held.left_out[p] || boundary.load[p].isZero(0)) continue;
    for (std::size_t i = 0; i < 3; ++i) lost[i] += boundary.load[p][Index(i)];
    lost[3] += 1.0;
  }
  add_up(ranks, lost);
  const auto number = [&](std::size_t i) { return to_double(lost[i]); };
  if (number(3) == 0) return "";
  const std::string where = load_case.empty() ? "" : " of load case \"" + load_case + "\"";
  return fmt::format(
      "loads{} on {:.0f} dropped particles are not carried, force ({:.6g}, {:.6g}, {:.6g}) in all", where,
      number(3), number(0), number(1), number(2));
}

}  // namespace bondstatic
