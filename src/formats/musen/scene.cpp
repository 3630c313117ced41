#include "formats/musen/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/musen/object.hpp"
#include "io/number_field.hpp"

namespace bondstatic {
namespace {

constexpr int lines_between_progress = 1 << 14;
constexpr double last_time = std::numeric_limits<double>::infinity();
constexpr Index object_key = 0, periodic_key = 28, anisotropy_key = 29, compound_key = 32;

/// What lines hold that a bonded packing does not need.
const std::map<Index, std::string>& skipped_lines() {
  static const std::map<Index, std::string> names{
      {22, "simulation domains"}, {25, "geometries"},       {26, "motions of geometries"},
      {27, "geometries"},         {30, "contact radii"},    {33, "interactions of materials"},
      {34, "mixtures"},           {38, "analysis volumes"}, {39, "package generators"},
      {40, "package generators"}, {41, "bond generators"}};
  return names;
}

class SceneReader {
 public:
  SceneReader(const LineReader& reader, double wanted_time, std::vector<Fault>& faults)
      : reader_(reader), line_(reader, faults), wanted_time_(wanted_time) {
    scene.sphere_keys.set();
  }

  void read(std::string_view text) {
    line_.take(text);
    if (line_.at_end()) return;
    const auto key = line_.whole("the key");
    if (!key) return;
    if (*key == object_key) {
      if (const auto object = read_musen_object(line_, wanted_time_, times)) add(*object);
    } else if (*key == compound_key) {
      read_material();
    } else if (*key == periodic_key) {
      read_periodic();
    } else if (*key == anisotropy_key) {
      if (const auto flag = line_.numbers(1)) scene.orientations_followed = (*flag)[0] != 0;
    } else if (const auto skipped = skipped_lines().find(*key); skipped != skipped_lines().end()) {
      ++scene.left[skipped->second];
    } else {
      line_.fault(fmt::format("{} begins no line of MUSEN's text export", *key));
    }
  }

  bool gave_up() const { return line_.gave_up(); }

  /// Only what is there at a time.
  void keep(double time) {
    keep(scene.spheres, sphere_state_, time);
    keep(scene.bonds, bond_state_, time);
    scene.time = time;
  }

  MusenScene scene;
  std::set<double> times;

 private:
  struct StateOf {
    double time, from, to;
  };

  template <class Object>
  void keep(std::vector<Object>& objects, const std::vector<StateOf>& states, double time) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const StateOf& state = states[i];
      const bool active =
          state.time == time && state.from <= time && time <= state.to && state.from != state.to;
      if (active) objects[kept++] = objects[i];
    }
    scene.inactive += Index(objects.size() - kept);
    objects.resize(kept);
  }

  int material_of(std::string_view key) {
    if (key.empty() || key == "Undefined") return -1;
    auto& keys = scene.material_keys;
    const auto known = std::find(keys.begin(), keys.end(), key);
    const int position = int(known - keys.begin());
    if (known == keys.end()) keys.emplace_back(key);
    return position;
  }

  void add(const MusenObject& object) {
    using Type = MusenObject::Type;
    const StateOf state{object.has_state ? object.time : not_given, object.active_from, object.active_to};
    const auto fault = [&](const std::string& what) {
      line_.fault(fmt::format("object {}: {}", object.id, what));
    };
    const auto& geometry = object.geometry;
    if (object.type == Type::sphere) {
      if (!(geometry[0] > 0)) return fault(fmt::format("radius = {} must be positive", geometry[0]));
      if (object.has_state && !object.has_position && object.keys.test(musen_key::coordinate))
        return fault(fmt::format("no coordinates at time {}, but at others", object.time));
      scene.sphere_keys &= object.keys;
      scene.spheres.push_back({object.id, reader_.line(), material_of(object.material), geometry[0],
                               object.position, object.velocity, object.angular_velocity, object.force,
                               turned(object)});
      sphere_state_.push_back(state);
    } else if (object.type == Type::solid_bond) {
      for (const double end : {geometry[0], geometry[1]})
        if (!(end >= 0 && end < double(above_every_whole_number) && end == std::trunc(end)))
          return fault(fmt::format("particle id {} must be a whole number, not negative", end));
      if (!(geometry[2] > 0 && geometry[3] > 0))
        return fault(fmt::format("diameter {} and length {} must be positive", geometry[2], geometry[3]));
      scene.bonds.push_back({object.id, Index(geometry[0]), Index(geometry[1]), reader_.line(),
                             material_of(object.material), geometry[2], geometry[3]});
      bond_state_.push_back(state);
    } else {
      ++scene.left[object.type == Type::wall ? "walls" : "liquid bonds"];
    }
  }

  static Eigen::Quaterniond turned(const MusenObject& object) {
    const bool known = object.orientation.norm() > 0 && object.first_orientation.norm() > 0;
    if (!known) return Eigen::Quaterniond::Identity();
    return (object.orientation * object.first_orientation.inverse()).normalized();
  }

  /// Key, name (of any number of words), and pairs of property and value.
  void read_material() {
    if (line_.at_end()) return line_.fault("the line ends where the key of a material must be");
    MusenMaterial& material = scene.materials[std::string(line_.next_text())];
    while (!line_.at_end() && (line_.left() % 2 == 1 || !whole_number_field(line_.text_ahead())))
      material.name += (material.name.empty() ? "" : " ") + std::string(line_.next_text());
    while (!line_.at_end()) {
      const auto property = line_.whole("the number of a property");
      const auto value = property ? line_.numbers(1) : std::nullopt;
      if (!value) return;
      material.property[*property] = (*value)[0];
    }
  }

  void read_periodic() {
    const auto flags = line_.numbers(4);
    const auto box = flags ? line_.numbers(6) : std::nullopt;
    if (!box || (*flags)[0] == 0) return;
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
      cell.origin[axis] = (*box)[std::size_t(axis)];
      cell.edges(axis, axis) = (*box)[std::size_t(axis) + 3] - cell.origin[axis];
      cell.periodic[std::size_t(axis)] = (*flags)[std::size_t(axis) + 1] != 0;
      if (!(cell.edges(axis, axis) > 0))
        return line_.fault("the periodic box has an edge that is not positive");
    }
    if (cell.periodic != std::array{false, false, false}) scene.cell = cell;
  }

  const LineReader& reader_;
  MusenLine line_;
  double wanted_time_;
  std::vector<StateOf> sphere_state_, bond_state_;
};

}  // namespace

bool heads_musen_text(const std::vector<std::string_view>& f) {
  const auto is_type = [](std::string_view type) {
    return type == "1" || type == "9" || type == "13" || type == "14";
  };
  return f.size() >= 5 && f[0] == "0" && whole_number_field(f[1]) && f[2] == "1" && is_type(f[3]) &&
         f[4] == "5";
}

std::optional<MusenScene> read_musen_scene(const std::string& path, const ReadOptions& options,
                                           const Place& named_at, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  auto reader = LineReader::open(path, named_at, faults);
  if (!reader) return std::nullopt;
  const auto read = [&](double wanted_time) {
    SceneReader scene(*reader, wanted_time, faults);
    while (const auto line = reader->next(faults)) {
      scene.read(*line);
      if (scene.gave_up()) break;
      if (options.progress && reader->line() % lines_between_progress == 0) options.progress(reader->part());
    }
    return scene;
  };
  SceneReader found = read(last_time);
  if (faults.size() != before) return std::nullopt;
  const Index times = Index(found.times.size());
  const bool positions = found.scene.sphere_keys.test(musen_key::coordinate);
  if (times == 0 || found.scene.spheres.empty() || !positions) {
    faults.push_back({{path, 1, 1},
                      found.scene.spheres.empty() ? "the export has no spheres"
                      : times == 0                ? "the export has no time points"
                                                  : "the export has no coordinates",
                      "export the particles, and their coordinates at one time point or more"});
    return std::nullopt;
  }
  if (options.step && (*options.step < 1 || *options.step > times)) {
    faults.push_back({named_at,
                      fmt::format("there is no time {} in \"{}\", which has {}", *options.step, path, times),
                      "times are counted from 1; leave the step out for the last"});
    return std::nullopt;
  }
  const double time = *std::next(found.times.begin(), options.step.value_or(times) - 1);
  if (time != *found.times.rbegin()) {
    reader->go_to(0, 1, faults);
    found.scene = {};  // before the next one is read
    SceneReader again = read(time);
    if (faults.size() != before) return std::nullopt;
    again.keep(time);
    again.scene.times = times;
    return std::move(again.scene);
  }
  found.keep(time);
  found.scene.times = times;
  return std::move(found.scene);
}

}  // namespace bondstatic
