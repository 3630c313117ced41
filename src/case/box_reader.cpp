#include "case/box_reader.hpp"

#include <cmath>
#include <limits>

namespace bondstatic {
namespace {

/// Infinite components are taken out and put back around the finite reading of the others.
std::optional<Vector3> read_corner(TableReader& reader, const std::string& key, double fallback) {
  const Node* node = reader.find(key);
  if (!node) return Vector3::Constant(fallback);
  Node finite = *node;
  std::vector<double> infinite;
  for (Node& item : finite.items) {
    const bool endless = item.kind == Node::Kind::real && std::isinf(item.real);
    infinite.push_back(endless ? item.real : 0);
    if (endless) item.real = 0;
  }
  auto corner = read_vector(reader.reading(), finite, key, dimension::length);
  for (int i = 0; corner && i < 3; ++i)
    if (infinite[std::size_t(i)] != 0) (*corner)[i] = infinite[std::size_t(i)];
  return corner;
}

}  // namespace

std::optional<std::function<bool(const Particle&)>> box_test(TableReader reader) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  if (!reader.has("min") && !reader.has("max"))
    reader.require("min", "add min = [X, Y, Z] and max = [X, Y, Z]");
  const auto low = read_corner(reader, "min", -inf), high = read_corner(reader, "max", inf);
  reader.finish();
  if (!low || !high) return std::nullopt;
  for (int i = 0; i < 3; ++i)
    if ((*low)[i] > (*high)[i]) {
      reader.reading().fault(reader.place_of("max"), "box: max is below min in a component", "swap them");
      return std::nullopt;
    }
  return [low = *low, high = *high](const Particle& p) {
    const double slack = 1e-9 * p.radius;
    return ((p.position - low).array() >= -slack).all() && ((high - p.position).array() >= -slack).all();
  };
}

}  // namespace bondstatic
