#include "python/analysis.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/named_parameter.hpp"
#include "python/model_steps.hpp"
#include "python/parts.hpp"
#include "results/linearise.hpp"

namespace bondstatic {

namespace {

/// What may not change between solves on one analysis (StaticAnalysis::solve).
bool same_pattern(const Model& left, const Model& right) {
  const auto same = [](const auto& a, const auto& b, auto equal) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
  };
  return left.load_cases == right.load_cases &&
         same(left.particles, right.particles,
              [](const Particle& a, const Particle& b) {
                return a.position == b.position && a.radius == b.radius;
              }) &&
         same(left.bonds, right.bonds,
              [](const Bond& a, const Bond& b) {
                return a.a == b.a && a.b == b.b && a.branch == b.branch && a.block == b.block;
              }) &&
         same(left.supports, right.supports, [](const Support& a, const Support& b) {
           return a.particle == b.particle && a.fixed == b.fixed && a.load_case == b.load_case;
         });
}

ParameterDerivative changes(const Solved& solved, const BlockParameter& at) {
  return bond_derivatives(*solved.model, at.block, at.parameter, solved.solution.report.threads);
}

using Derivatives = std::vector<std::vector<double>>;

/// [output][parameter]: dJ/dp where all bonds that the key names change together.
Derivatives derivatives(PythonAnalysis& analysis, const std::shared_ptr<const Solved>& solved,
                        const std::vector<Output>& outputs,
                        const std::vector<std::vector<BlockParameter>>& parameters) {
  const std::vector<BondGradients> gradients = analysis.gradients(solved, outputs);
  const py::gil_scoped_release others_may_run;
  Derivatives result(outputs.size(), std::vector<double>(parameters.size(), 0.0));
  for (std::size_t p = 0; p < parameters.size(); ++p)
    for (const BlockParameter& at : parameters[p]) {
      const ParameterDerivative change = changes(*solved, at);
      for (std::size_t o = 0; o < outputs.size(); ++o) result[o][p] += derivative(gradients[o], change);
    }
  return result;
}

/// [output]: dJ/d(each bond's own value), NaN for bonds that have no such parameter.
std::vector<py::array> derivatives_by_bond(PythonAnalysis& analysis,
                                           const std::shared_ptr<const Solved>& solved,
                                           const std::vector<Output>& outputs,
                                           const std::vector<BlockParameter>& places) {
  const std::vector<BondGradients> gradients = analysis.gradients(solved, outputs);
  std::vector<std::vector<double>> result(outputs.size(),
                                          std::vector<double>(solved->model->bonds.size(), not_given));
  {
    const py::gil_scoped_release others_may_run;
    for (const BlockParameter& at : places) {
      const ParameterDerivative change = changes(*solved, at);
      for (std::size_t o = 0; o < outputs.size(); ++o) {
        const std::vector<double> of_bond = derivative_by_bond(gradients[o], change);
        for (std::size_t k = 0; k < of_bond.size(); ++k) result[o][std::size_t(change.bonds[k])] = of_bond[k];
      }
    }
  }
  std::vector<py::array> arrays;
  for (std::vector<double>& values : result) arrays.push_back(taken(std::move(values)));
  return arrays;
}

std::vector<BlockParameter> places_of(const Model& model, const std::string& key) {
  const NamedParameter named = find_parameter(model, key);
  if (named.places.empty()) {
    std::vector<Fault> faults{{Place{}, named.message, named.cure}};
    throw InputError(std::move(faults));
  }
  return named.places;
}

/// The same where bonds with values of their own count, too.
std::vector<BlockParameter> places_by_bond(const Model& model, const std::string& key) {
  Model as_blocks;
  as_blocks.blocks = model.blocks;
  for (BondBlock& block : as_blocks.blocks)
    for (const auto& [p, values] : std::exchange(block.overrides, {}))
      for (const double value : values)
        if (!std::isnan(value)) block.parameters[p] = value;
  return places_of(as_blocks, key);
}

}  // namespace

std::shared_ptr<Solved> PythonAnalysis::solve(std::shared_ptr<const Model> model,
                                              const py::object& progress) {
  const auto solved = std::make_shared<Solved>();
  solved->model = std::move(model);
  solved->options = options_;
  auto owned = std::exchange(owned_, nullptr);
  if (owned && !same_pattern(owned->model, *solved->model)) owned = nullptr;
  const bool again = owned != nullptr;
  if (!again) owned = std::make_shared<OwnedAnalysis>();
  run_watched([solved, owned, again, callback = Callback(progress)](Watch& watch) {
    owned->model = *solved->model;
    owned->progress = phases_to(watch, callback);
    if (!again) {
      StaticOptions options = solved->options;
      options.progress = [&heard = owned->progress](const std::string& phase) { heard(phase); };
      owned->analysis = std::make_unique<StaticAnalysis>(owned->model, options);
    }
    solved->solution = owned->analysis->solve();
  });
  owned->last = solved;
  owned_ = owned;
  return solved;
}

std::vector<BondGradients> PythonAnalysis::gradients(const std::shared_ptr<const Solved>& solved,
                                                     const std::vector<Output>& outputs) {
  expect_outputs_of(*solved->model, outputs);
  if (!owned_ || owned_->last.lock() != solved) {
    solve(solved->model, py::none());
    owned_->last = solved;  // the same model has the same answer, to the last bit
  }
  const auto owned = std::exchange(owned_, nullptr);
  const auto result = std::make_shared<std::vector<BondGradients>>();
  run_watched([solved, owned, outputs, result](Watch& watch) {
    owned->progress = phases_to(watch, Callback());
    std::vector<Functionals> scalars;
    for (const Output& output : outputs)
      scalars.push_back(linearise(output, owned->model, solved->solution, owned->analysis->properties()));
    *result = owned->analysis->gradients(scalars);
  });
  owned_ = owned;
  return std::move(*result);
}

void add_analysis(py::module_& module) {
  py::class_<PythonAnalysis>(module, "Analysis")
      .def(py::init<StaticOptions>(), py::arg("options"))
      .def(
          "solve",
          [](PythonAnalysis& self, const PythonModel& model, const py::object& progress) {
            return self.solve(model.edited.kept(), progress);
          },
          py::arg("model"), py::arg("progress"))
      .def(
          "derivatives",
          [](PythonAnalysis& self, const std::shared_ptr<Solved>& solved, const std::vector<Output>& outputs,
             const std::vector<std::string>& keys) {
            std::vector<std::vector<BlockParameter>> parameters;
            for (const std::string& key : keys) parameters.push_back(places_of(*solved->model, key));
            return derivatives(self, solved, outputs, parameters);
          },
          py::arg("solved"), py::arg("outputs"), py::arg("keys"))
      .def(
          "derivatives_by_bond",
          [](PythonAnalysis& self, const std::shared_ptr<Solved>& solved, const std::vector<Output>& outputs,
             const std::string& key) {
            return derivatives_by_bond(self, solved, outputs, places_by_bond(*solved->model, key));
          },
          py::arg("solved"), py::arg("outputs"), py::arg("key"));
  module.def(
      "keys",
      [](const Solved& solved, const std::string& key) {
        std::vector<std::string> keys;
        for (const BlockParameter& at : places_of(*solved.model, key))
          keys.push_back(key_of(*solved.model, at));
        return keys;
      },
      py::arg("solved"), py::arg("key"), "\"bonds.0.young\" of each block that a key names.");
}

}  // namespace bondstatic
