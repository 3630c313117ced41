#include "python/model_arrays.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "case/cell.hpp"
#include "python/node_of.hpp"

namespace bondstatic {

namespace {

constexpr int most_faults = 20;

/// Says what is wrong with single rows of an array, the first twenty of each.
class RowFaults {
 public:
  template <class Value>
  void add(const std::string& array, std::size_t row, Value value, const char* what, const char* cure) {
    if (++count_[array] <= most_faults)
      faults_.push_back({{"Model", 0, 0}, fmt::format("{}[{}] = {} {}", array, row, value, what), cure});
  }
  void stop() const {
    if (!faults_.empty()) throw InputError(faults_);
  }

 private:
  std::vector<Fault> faults_;
  std::map<std::string, int> count_;
};

}  // namespace

std::unique_ptr<PythonModel> model_of(const ArrayOf<double>& x, const ArrayOf<double>& radius,
                                      const ArrayOf<Index>& ids,
                                      const std::optional<ArrayOf<double>>& density,
                                      const std::optional<ArrayOf<Index>>& bonds, const py::object& cell) {
  const auto count = std::size_t(x.shape(0));
  RowFaults faults;
  Model model;
  model.particles.resize(count);
  IdTable known;
  known.expect(Index(count));
  for (std::size_t p = 0; p < count; ++p) {
    Particle& particle = model.particles[p];
    const auto row = py::ssize_t(p);
    for (int i = 0; i < 3; ++i) {
      particle.position[i] = x.data()[3 * p + std::size_t(i)];
      if (!std::isfinite(particle.position[i]))
        faults.add("x", p, particle.position[i], "must be finite", "give the particle a place");
    }
    particle.id = ids.at(row);
    if (particle.id < 0)
      faults.add("ids", p, particle.id, "must not be negative", "number particles from 0 or 1 on");
    else if (!known.add(particle.id, Index(p)))
      faults.add("ids", p, particle.id, "is there twice", "give every particle an id of its own");
    particle.radius = radius.at(row);
    if (!(particle.radius > 0) || std::isinf(particle.radius))
      faults.add("radius", p, particle.radius, "must be positive", "give the radius of the sphere");
    if (density) particle.density = density->at(row);
    if (density && !(particle.density > 0 && std::isfinite(particle.density)))
      faults.add("density", p, particle.density, "must be positive",
                 "give 2650, say (kg/m3 in SI), or leave density out");
  }
  faults.stop();
  auto made = std::make_unique<PythonModel>();
  made->edited = EditedModel(std::move(model));
  if (!cell.is_none())
    made->edited.edit("Model", [&](Draft& draft) {
      Node table = node_of(cell, "Model");
      read_cell(draft, &table);
    });
  if (bonds) {
    ForeignModel listed;
    listed.bonds.resize(std::size_t(bonds->shape(0)));
    for (std::size_t k = 0; k < listed.bonds.size(); ++k) {
      listed.bonds[k].a = bonds->data()[2 * k];
      listed.bonds[k].b = bonds->data()[2 * k + 1];
    }
    made->listed = std::make_shared<const ForeignModel>(std::move(listed));
  }
  return made;
}

py::array positions_of(const PythonModel& self, const ArrayOf<Index>& ids) {
  std::vector<Index> found;
  RowFaults faults;
  for (py::ssize_t i = 0; i < ids.size(); ++i) {
    const Index* position = self.edited.draft().particle_of_id.position_of(ids.at(i));
    if (position)
      found.push_back(*position);
    else
      faults.add("ids", std::size_t(i), ids.at(i), "is no particle's",
                 "check the id; without ids they are rows of x");
  }
  faults.stop();
  return taken(std::move(found));
}

}  // namespace bondstatic
