#include "case/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "case/calibration_parameters.hpp"
#include "case/calibration_targets.hpp"
#include "case/overrides.hpp"

namespace bondstatic {
namespace {

using Choices = std::vector<std::string>;

void read_cases(Reading& reading, TableReader& calibration, CalibrationPlan& plan) {
  Node* list = calibration.find("cases");
  if (!list || !calibration.texts("cases")) return;
  if (!list->is_array())
    return reading.fault(list->place, "cases must be a list",
                         fmt::format("write cases = [{}]", shown(*list)));
  std::set<std::string> names{test_name(reading.file, reading.file)};
  for (Node& item : list->items) {
    const std::string written = item.text;
    const std::string file = resolve_path(reading, item);
    if (names.insert(test_name(reading.file, file)).second)
      plan.cases.push_back(file);
    else
      reading.fault(item.place, fmt::format("\"{}\" is a test already", written),
                    "name other cases than this one, and each once");
  }
}

void read_seeds(Draft& draft, Node& root, Node& table, CalibrationPlan& plan) {
  Reading& reading = draft.reading;
  TableReader seeds(reading, table, "seeds");
  if (!table.is_table()) return;
  seeds.require("key", "add key = \"bonds.0.seed\", for one");
  plan.seed_key = seeds.text("key").value_or("");
  if (Node* values = seeds.find("values"); values && values->is_array()) {
    for (const Node& item : values->items) {
      const auto seed = read_whole(reading, item, "values", 0);
      if (!seed) continue;
      if (std::find(plan.seeds.begin(), plan.seeds.end(), *seed) == plan.seeds.end())
        plan.seeds.push_back(*seed);
      else
        reading.fault(item.place, fmt::format("seed {} is there twice", *seed), "give each seed once");
    }
  }
  if (plan.seeds.empty())
    reading.fault(seeds.place_of("values"), "seeds needs values, a list of whole numbers",
                  "write values = [1, 2, 3]");
  seeds.finish();
  if (plan.seed_key.empty() || !draft.particles_known || !draft.bonds_known) return;
  const Node* node = find_node(root, plan.seed_key);
  if (!node || node->kind != Node::Kind::whole)
    reading.fault(seeds.place_of("key"),
                  node ? fmt::format("{} = {} is no whole number", plan.seed_key, shown(*node))
                       : fmt::format("the case has no {}", plan.seed_key),
                  "name a seed: bonds.0.seed of law edem-v2, or particles.0.seed");
}

}  // namespace

CalibrationPlan read_calibration_plan(Draft& draft, Node& root, const std::vector<Output>& outputs) {
  const std::size_t before = draft.reading.faults.size();
  CalibrationPlan plan;
  Node& table = *root.find("calibration");
  TableReader calibration(draft.reading, table, "[calibration]");
  if (!table.is_table()) return plan;
  read_cases(draft.reading, calibration, plan);
  if (Node* seeds = calibration.find("seeds")) read_seeds(draft, root, *seeds, plan);
  const Choices losses{"squares", "huber", "cauchy"};
  const std::string loss = calibration.choice_or("loss", losses.front(), losses);
  plan.options.loss = Loss(std::find(losses.begin(), losses.end(), loss) - losses.begin());
  plan.options.most_evaluations = int(
      std::min<Index>(calibration.whole_or("most_evaluations", plan.options.most_evaluations, 1), 1 << 30));
  for (const char* name : {"parameters", "targets"}) {
    const Node* list = calibration.find(name);
    if (!list || (list->is_array() && list->items.empty()))
      draft.reading.fault(calibration.place_of(name), fmt::format("[calibration] has no {}", name),
                          fmt::format("add [[calibration.{}]]", name));
  }
  read_calibration_parameters(draft, calibration.find("parameters"), plan);
  const Index count = read_calibration_targets(draft.reading, calibration, outputs, plan);
  if (plan.options.loss != Loss::squares && !plan.targets.empty() &&
      std::isnan(plan.targets.front().tolerance))
    draft.reading.fault(calibration.place_of("loss"),
                        fmt::format("loss = \"{}\" needs tolerances, which say what is far off", loss),
                        "give every target a tolerance, or write loss = \"squares\"");
  if (draft.reading.faults.size() == before && Index(plan.parameters.size()) > count)
    draft.reading.fault(calibration.place(),
                        fmt::format("{} parameters are more than {} target{} can tell",
                                    plan.parameters.size(), count, count == 1 ? "" : "s"),
                        "add targets, or calibrate fewer parameters");
  calibration.finish();
  return plan;
}

}  // namespace bondstatic
