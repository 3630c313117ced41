#include "model/boundary.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

constexpr const char* dof_names[6] = {"x", "y", "z", "rx", "ry", "rz"};

bool concerns(Index named, Index load_case) {
  return named == every_case || named == load_case;
}

}  // namespace

Boundary boundary_of(const Model& model, Index load_case) {
  const std::size_t count = model.particles.size();
  Boundary boundary{std::vector<std::uint8_t>(count, 0x3f), std::vector<Vector6>(count, Vector6::Zero()),
                    std::vector<Vector6>(count, Vector6::Zero()), Matrix3::Zero()};
  for (const Support& support : model.supports) {
    if (!concerns(support.load_case, load_case)) continue;
    const auto p = std::size_t(support.particle);
    for (int i = 0; i < 6; ++i) {
      if (!support.fixed[std::size_t(i)]) continue;
      const bool already = !((boundary.free[p] >> i) & 1);
      if (already && boundary.prescribed[p][i] != support.value[i])
        throw Error(
            ExitCode::invalid_input,
            fmt::format("particle {}: {} is prescribed both {} and {}\n    cure: keep one of the supports",
                        model.particles[p].id, dof_names[i], boundary.prescribed[p][i], support.value[i]));
      boundary.free[p] = std::uint8_t(boundary.free[p] & ~(1u << i));
      boundary.prescribed[p][i] = support.value[i];
    }
  }
  for (const Load& load : model.loads)
    if (concerns(load.load_case, load_case)) boundary.load[std::size_t(load.particle)] += load.force;
  for (const Strain& strain : model.strains)
    if (concerns(strain.load_case, load_case)) boundary.strain += strain.value;
  return boundary;
}

}  // namespace bondstatic
