#include "case/calibration_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "case/named_parameter.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {
namespace {

/// Bounds and start within what the law allows and within each other. False after a fault.
bool check_numbers(TableReader& block, const Parameter& law, const CalibrationParameter& parameter) {
  Reading& reading = block.reading();
  const std::size_t before = reading.faults.size();
  const auto allow = [&](const char* key, double value) {
    const bool above = law.lower_included ? value >= law.lower : value > law.lower;
    if (above && value <= law.upper) return;
    reading.fault(block.place_of(key),
                  fmt::format("{} = {} is outside of what {} can be: {} {}{}", key, value, law.name,
                              law.lower_included ? "at least" : "more than", law.lower,
                              std::isfinite(law.upper) ? fmt::format(", at most {}", law.upper) : ""),
                  "keep the bounds inside");
  };
  allow("min", parameter.lower);
  allow("max", parameter.upper);
  if (!(parameter.lower < parameter.upper))
    reading.fault(block.place_of("max"),
                  fmt::format("max = {} must be more than min = {}", parameter.upper, parameter.lower),
                  "give the range that the parameter may be in");
  else if (block.has("start") && !(parameter.start >= parameter.lower && parameter.start <= parameter.upper))
    reading.fault(block.place_of("start"),
                  fmt::format("start = {} is outside of min = {} to max = {}", parameter.start,
                              parameter.lower, parameter.upper),
                  "start inside");
  return reading.faults.size() == before;
}

void read_scale(TableReader& block, CalibrationParameter& parameter) {
  const bool can_be_log = parameter.lower > 0;
  parameter.logarithmic = block.choice_or("scale", can_be_log ? "log" : "linear",
                                          std::vector<std::string>{"log", "linear"}) == "log";
  if (parameter.logarithmic && !can_be_log)
    block.reading().fault(block.place_of("scale"),
                          fmt::format("scale = \"log\" needs min > 0, which is {}", parameter.lower),
                          "raise min, or write scale = \"linear\"");
}

/// What the case has, and is told where that is not quite so: a sweep may well leave the range.
double start_of_case(TableReader& block, const Model& model, const NamedParameter& named, double lower,
                     double upper) {
  const BlockParameter& first = named.places.front();
  const double value = value_at(model, first), start = std::clamp(value, lower, upper);
  const auto tell = [&](const BlockParameter& place) {
    const Fault told{block.place(),
                     fmt::format("a calibration starts from {}, not from {} = {}", start,
                                 key_of(model, place), value_at(model, place)),
                     ""};
    block.reading().warnings.push_back(to_string(told));
  };
  for (const BlockParameter& place : named.places)
    if (value_at(model, place) != start) tell(place);
  return start;
}

void read_numbers(TableReader& block, const Model& model, const NamedParameter& named,
                  CalibrationParameter& parameter) {
  const Parameter& law = parameter_at(model, named.places.front());
  const auto lower = block.number("min", law.dimension), upper = block.number("max", law.dimension);
  const double value = value_at(model, named.places.front());
  for (const char* key : {"min", "max"})
    block.require(key, fmt::format("add {} = ..: the case has {}", key, value));
  const auto start = block.number("start", law.dimension);
  parameter.lower = lower.value_or(not_given);
  parameter.upper = upper.value_or(not_given);
  parameter.start = start.value_or(not_given);
  const bool told = lower && upper && (start || !block.has("start"));
  if (!told || !check_numbers(block, law, parameter)) return block.accept_any();
  read_scale(block, parameter);
  if (!start) parameter.start = start_of_case(block, model, named, parameter.lower, parameter.upper);
  block.set_default("start", Node::of(parameter.start));
}

}  // namespace

void read_calibration_parameters(Draft& draft, Node* list, CalibrationPlan& plan) {
  std::map<std::string, std::string> taken;  ///< which parameter has the place
  for_each_table(draft.reading, list, "calibration.parameters", [&](TableReader& block) {
    block.require("key", "add key = \"bonds.0.young\", for one");
    CalibrationParameter parameter;
    parameter.name = block.text("key").value_or("");
    plan.parameters.push_back(parameter);
    if (parameter.name.empty() || !draft.bonds_known) return block.accept_any();
    const NamedParameter named = find_parameter(draft.model, parameter.name);
    if (named.places.empty()) {
      draft.reading.fault(block.place_of("key"), named.message, named.cure);
      return block.accept_any();
    }
    for (const BlockParameter& place : named.places) {
      const auto [other, free] = taken.emplace(key_of(draft.model, place), parameter.name);
      if (!free)
        draft.reading.fault(block.place_of("key"),
                            fmt::format("{} is calibrated already, by \"{}\"", other->first, other->second),
                            "name each parameter once");
    }
    read_numbers(block, draft.model, named, parameter);
    plan.parameters.back() = parameter;
  });
}

}  // namespace bondstatic
