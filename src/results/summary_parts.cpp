#include "results/summary_parts.hpp"

#include <set>

#include "bondstatic/results.hpp"
#include "results/load_case_folder.hpp"

namespace bondstatic {

Json counts_of(const Model& model) {
  std::set<Index> supported;
  for (const Support& support : model.supports) supported.insert(support.particle);
  std::vector<Index> in_block(model.blocks.size());
  for (const Bond& bond : model.bonds) ++in_block[std::size_t(bond.block)];
  Json laws = Json::object();
  for (std::size_t b = 0; b < in_block.size(); ++b) {
    const Json& so_far = laws.emplace(model.blocks[b].law, 0).first.value();
    laws[model.blocks[b].law] = so_far.get<Index>() + in_block[b];
  }
  return {{"particles", model.particles.size()},
          {"bonds", model.bonds.size()},
          {"bonds_by_law", laws},
          {"supported_particles", supported.size()},
          {"load_cases", model.load_cases.size()}};
}

Json outputs_of(const std::vector<OutputValue>& outputs) {
  Json all = Json::array();
  for (const OutputValue& output : outputs) {
    Json one{{"name", output.name}, {"value", output.value}};
    if (output.expected) {
      one["expected"] = *output.expected;
      one["relative_error"] = output.relative_error();
      one["tolerance"] = output.tolerance;
    }
    if (!output.source.empty()) one["source"] = output.source;
    all.push_back(std::move(one));
  }
  return all;
}

Json state_of(const Model& model, const State& state) {
  Json one{{"name", state.name},
           {"folder", load_case_folder(model, state.name)},
           {"energy", state.energy},
           {"work", state.work}};
  if (const LargestDisplacement largest = largest_displacement(state); largest.particle >= 0) {
    const Vector3& u = largest.displacement;
    one["largest_displacement"] = {{"particle", model.particles[std::size_t(largest.particle)].id},
                                   {"magnitude", u.stableNorm()},
                                   {"components", {u.x(), u.y(), u.z()}}};
  }
  return one;
}

Json bodies_of(const Model& model, const std::vector<std::vector<Index>>& dropped) {
  Json bodies = Json::array();
  for (const std::vector<Index>& body : dropped) {
    Json ids = Json::array();
    for (const Index p : body) ids.push_back(model.particles[std::size_t(p)].id);
    bodies.push_back(std::move(ids));
  }
  return bodies;
}

std::string to_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

LargestDisplacement largest_displacement(const State& state) {
  LargestDisplacement largest;
  double most = -1;
  for (std::size_t i = 0; i < state.displacement.size(); ++i) {
    const double magnitude = state.displacement[i].head<3>().stableNorm();
    if (!(magnitude > most)) continue;  // nor where it is NaN
    most = magnitude;
    largest = {Index(i), state.displacement[i].head<3>()};
  }
  return largest;
}

}  // namespace bondstatic
