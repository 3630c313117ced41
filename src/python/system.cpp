// The stiffness matrix and the system that is solved, for who wants to solve it by other means.
#include "bondstatic/bond_law.hpp"
#include "bondstatic/network.hpp"
#include "model/boundary.hpp"
#include "python/background.hpp"
#include "python/parts.hpp"
#include "python/python_model.hpp"
#include "solver/machine.hpp"
#include "statics/held.hpp"
#include "statics/residual.hpp"
#include "system/assemble.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

/// Lower triangle of K, compressed columns.
struct Assembled {
  SparseMatrix lower;
  std::vector<Index> dofs;                   ///< of each row: 6 * particle + 0 ... 5
  std::vector<double> right;                 ///< by row; none of the full matrix
  std::shared_ptr<const Boundary> boundary;  ///< likewise
};

BondNetwork unscaled_network(const Model& model, int threads) {
  BondNetwork network = bond_network(model, bond_properties(model, threads));
  network.rotation_length = 1;
  return network;
}

Assembled assembled(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                    int threads) {
  Assembled result;
  const BodyGraph graph = body_graph(network, incidence);
  result.lower = stiffness_pattern(graph, dofs);
  assemble(network, incidence, graph, dofs, threads, result.lower);
  result.dofs.reserve(std::size_t(dofs.unknowns()));
  for_each_unknown(dofs, [&](std::size_t p, int i, Index) { result.dofs.push_back(6 * Index(p) + i); });
  return result;
}

Assembled full_matrix(const Model& model, int threads) {
  const BondNetwork network = unscaled_network(model, threads);
  return assembled(network, link_incidence(network),
                   number_free_dofs(std::vector<std::uint8_t>(model.particles.size(), 63)), threads);
}

/// f - K u of what is prescribed, cell's strain included, in the rows that are free.
Assembled reduced_system(const Model& model, Index load_case, Unsupported unsupported, int threads) {
  const BondNetwork network = unscaled_network(model, threads);
  const Incidence incidence = link_incidence(network);
  const auto boundary = std::make_shared<const Boundary>(boundary_of(model, load_case));
  const Held held = held_by(model, network, boundary->free, unsupported);
  Assembled result = assembled(network, incidence, held.dofs, threads);
  const auto forces = residual(network, *boundary, converted<Extended>(boundary->prescribed), threads);
  const Eigen::VectorXd right = to_unknowns(forces, held.dofs, 1);
  result.right.assign(right.data(), right.data() + right.size());
  result.boundary = boundary;
  return result;
}

py::tuple as_arrays(std::shared_ptr<const Assembled> system) {
  const SparseMatrix& k = system->lower;
  const auto entries = py::ssize_t(k.nonZeros());
  const std::size_t bodies = system->boundary ? system->boundary->prescribed.size() : 0;
  const double* prescribed = bodies ? system->boundary->prescribed.front().data() : nullptr;
  return py::make_tuple(view<double>(system, k.valuePtr(), {entries}, {sizeof(double)}),
                        view<Index>(system, k.innerIndexPtr(), {entries}, {sizeof(Index)}),
                        view<Index>(system, k.outerIndexPtr(), {py::ssize_t(k.cols() + 1)}, {sizeof(Index)}),
                        view_of_items<Index>(system, system->dofs, system->dofs.data()),
                        view_of_items<double>(system, system->right, system->right.data()),
                        view<double>(system, prescribed, {py::ssize_t(6 * bodies)}, {sizeof(double)}));
}

py::tuple made(std::function<Assembled()> make) {
  const auto system = std::make_shared<Assembled>();
  run_watched([system, make = std::move(make)](Watch&) { *system = make(); });
  return as_arrays(system);
}

}  // namespace

void add_system(py::module_& module) {
  module.def(
      "full_matrix",
      [](const PythonModel& self) {
        return made(
            [threads = cores_at_hand(), model = self.edited.kept()] { return full_matrix(*model, threads); });
      },
      py::arg("model"));
  module.def(
      "reduced_system",
      [](const PythonModel& self, Index load_case, bool drop) {
        return made([threads = cores_at_hand(), model = self.edited.kept(), load_case, drop] {
          return reduced_system(*model, load_case, drop ? Unsupported::drop : Unsupported::error, threads);
        });
      },
      py::arg("model"), py::arg("load_case"), py::arg("drop"));
}

}  // namespace bondstatic
