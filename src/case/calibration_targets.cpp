#include "case/calibration_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/output_dimension.hpp"
#include "case/toml_text.hpp"
#include "io/nearest_name.hpp"
#include "io/text_file.hpp"

namespace bondstatic {
namespace {

/// What of an output decides the unit of what is held against it.
struct Told {
  std::string name, of;
  double scale = 1;
  bool operator==(const Told&) const = default;
};

struct TestCase {
  std::string name;
  std::vector<Told> outputs;
  Index times = 1;  ///< once for each seed

  const Told* find(const std::string& output) const {
    const auto found =
        std::find_if(outputs.begin(), outputs.end(), [&](const Told& one) { return one.name == output; });
    return found == outputs.end() ? nullptr : &*found;
  }
};

/// Whatever else is wrong with the file is said when it is read as a case.
TestCase look_into(Reading& reading, const std::string& file, const Place& named_at) {
  TestCase test{test_name(reading.file, file), {}, 1};
  const auto text = read_text_file(file, named_at, reading.faults);
  auto root = text ? parse_toml(*text, file, reading.faults) : std::nullopt;
  Node* list = root ? root->find("outputs") : nullptr;
  if (!list || !list->is_array()) return test;
  for (Node& block : list->items) {
    const Node *name = block.find("name"), *of = block.find("of"), *scale = block.find("scale");
    if (!name || !of) continue;
    const double number = !scale ? 1 : scale->kind == Node::Kind::whole ? double(scale->whole) : scale->real;
    test.outputs.push_back({name->text, of->text, number});
  }
  return test;
}

std::vector<TestCase> tests_of(Reading& reading, TableReader& calibration, const std::vector<Output>& outputs,
                               const CalibrationPlan& plan) {
  std::vector<TestCase> tests(1);
  tests[0].name = test_name(reading.file, reading.file);
  tests[0].times = std::max<Index>(1, Index(plan.seeds.size()));
  for (const Output& output : outputs) tests[0].outputs.push_back({output.name, output.of, output.scale});
  for (const std::string& file : plan.cases)
    tests.push_back(look_into(reading, file, calibration.place_of("cases")));
  return tests;
}

/// The tests that a target may be of: the one that it names, or all.
std::vector<const TestCase*> tests_named(TableReader& block, const std::vector<TestCase>& tests,
                                         CalibrationTarget& target) {
  std::vector<const TestCase*> found;
  for (const TestCase& test : tests) found.push_back(&test);
  if (!block.text("case")) return found;
  Reading& reading = block.reading();
  Node& node = *block.find("case");
  const std::string written = node.text;
  std::vector<std::string> names{"this"};
  for (const TestCase& test : tests) names.push_back(test.name);
  target.test = tests[0].name;
  if (written == "this") return {&tests[0]};
  target.test = test_name(reading.file, resolve_path(reading, node));
  // The resolved case has another name.
  if (target.test == tests[0].name) node.text = "this";
  std::erase_if(found, [&](const TestCase* test) { return test->name != target.test; });
  if (!found.empty()) return found;
  const std::string nearest = nearest_name(written, names);
  reading.fault(
      node.place, fmt::format("case = \"{}\" is no test; there are: {}", written, name_list(names)),
      nearest.empty() ? "add it to cases of [calibration]" : fmt::format("did you mean \"{}\"?", nearest));
  return {};
}

/// Those that have the output; a fault where none has, or where they mean different things by its name.
std::vector<const TestCase*> tests_with(TableReader& block, std::vector<const TestCase*> tests,
                                        const std::string& output) {
  std::vector<std::string> names;
  for (const TestCase* test : tests)
    for (const Told& told : test->outputs) names.push_back(told.name);
  const bool asked = !tests.empty() && !output.empty();
  std::erase_if(tests, [&](const TestCase* test) { return !test->find(output); });
  if (asked && tests.empty()) {
    const std::string nearest = nearest_name(output, names);
    block.reading().fault(block.place_of("output"), fmt::format("there is no output \"{}\"", output),
                          !nearest.empty() ? fmt::format("did you mean \"{}\"?", nearest)
                          : names.empty()  ? "add [[outputs]]"
                                           : "there are: " + name_list(names));
  }
  for (const TestCase* test : tests)
    if (*test->find(output) != *tests.front()->find(output)) {
      block.reading().fault(block.place_of("output"),
                            fmt::format("output \"{}\" is not the same in {} and {}: of or scale differ",
                                        output, tests.front()->name, test->name),
                            "say which is meant: case = \"..\"");
      return {};
    }
  return tests;
}

/// As the output is told; a unit is turned into that.
std::optional<double> read_as_told(TableReader& block, const char* key, const Told& told, Allowed allowed) {
  const Node* node = block.find(key);
  if (!node || !node->is_text()) return block.number(key, dimension::none, allowed);
  const auto dimension = dimension_of_output(told.of);
  const auto scale = unit_scale(told.scale);
  if (dimension && scale) {
    const auto value = block.number(key, *dimension, allowed);
    return value ? std::optional(*value * *scale) : std::nullopt;
  }
  block.reading().fault(node->place,
                        fmt::format("{} = {}: the unit of \"{}\" cannot be told, as its scale is {}", key,
                                    shown(*node), told.name, told.scale),
                        fmt::format("write {} = NUMBER, as the output is told", key));
  return std::nullopt;
}

void check_once(TableReader& block, const CalibrationPlan& plan, const CalibrationTarget& target) {
  for (const CalibrationTarget& other : plan.targets)
    if (other.output == target.output &&
        (other.test.empty() || target.test.empty() || other.test == target.test))
      return block.reading().fault(block.place_of("output"),
                                   fmt::format("output \"{}\" is a target already", target.output),
                                   "give each output of each test one target");
}

/// Residuals are held against tolerances or against weights, not some of them against either.
void check_measure(TableReader& block, const CalibrationPlan& plan, const CalibrationTarget& target) {
  const bool has = block.has("tolerance");
  if (has && block.has("weight"))
    block.reading().fault(block.place_of("weight"), "tolerance and weight exclude each other",
                          "keep the tolerance: its square is what a weight would be over");
  if (!plan.targets.empty() && has == std::isnan(plan.targets.front().tolerance))
    block.reading().fault(block.place(),
                          fmt::format("\"{}\" has {} tolerance, but \"{}\" has {}", target.output,
                                      has ? "a" : "no", plan.targets.front().output, has ? "none" : "one"),
                          "give all targets a tolerance, or none");
}

}  // namespace

std::string test_name(const std::string& calibrated, const std::string& file) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(calibrated).lexically_normal().parent_path();
  return fs::absolute(file).lexically_normal().lexically_proximate(folder).generic_string();
}

Index read_calibration_targets(Reading& reading, TableReader& calibration, const std::vector<Output>& outputs,
                               CalibrationPlan& plan) {
  const std::vector<TestCase> tests = tests_of(reading, calibration, outputs, plan);
  Index count = 0;
  for_each_table(reading, calibration.find("targets"), "calibration.targets", [&](TableReader& block) {
    CalibrationTarget target;
    block.require("output", "add output = \"..\", a name of [[outputs]]");
    block.require("wanted", "add wanted = .., what was measured");
    target.output = block.text("output").value_or("");
    const auto found = tests_with(block, tests_named(block, tests, target), target.output);
    if (found.empty()) return block.accept_any();
    const Told& told = *found.front()->find(target.output);
    target.wanted = read_as_told(block, "wanted", told, Allowed::any).value_or(not_given);
    const auto tolerance = read_as_told(block, "tolerance", told, Allowed::positive);
    target.tolerance = block.has("tolerance") ? tolerance.value_or(1) : not_given;
    target.weight = block.number("weight", dimension::none, Allowed::positive).value_or(target.weight);
    check_measure(block, plan, target);
    if (!block.has("tolerance")) block.set_default("weight", Node::of(target.weight));
    check_once(block, plan, target);
    for (const TestCase* test : found) count += test->times;
    plan.targets.push_back(target);
  });
  return count;
}

}  // namespace bondstatic
