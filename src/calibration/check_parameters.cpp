#include "calibration/check_parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "bondstatic/bond_law.hpp"

namespace bondstatic {

namespace {

void check_range(const CalibrationParameter& parameter, std::vector<Fault>& faults) {
  const auto fault = [&](const std::string& what, const std::string& cure) {
    faults.push_back({{}, fmt::format("{}: {}", parameter.name, what), cure});
  };
  const double lower = parameter.lower, upper = parameter.upper;
  if (!std::isfinite(lower) || !std::isfinite(upper))
    fault(fmt::format("bounds {} and {} must be finite", lower, upper),
          "give the range in which an answer would be believed");
  else if (lower >= upper)
    fault(fmt::format("the lower bound {} must be below the upper bound {}", lower, upper),
          lower == upper ? "leave out a parameter that shall not move" : "exchange them");
  else if (parameter.logarithmic && lower <= 0)
    fault(fmt::format("the lower bound {} has no logarithm", lower),
          "give a positive one, or scale = \"linear\"");
  else if (!std::isnan(parameter.start) && !(parameter.start >= lower && parameter.start <= upper))
    fault(fmt::format("the start {} is outside of the bounds {} and {}", parameter.start, lower, upper),
          "start inside of them, or widen them");
}

// The law's own bounds: lower < value, or lower <= value.
void check_law(const CalibrationTest& test, const BlockParameter& moved,
               const CalibrationParameter& parameter, std::vector<Fault>& faults) {
  const BondBlock& block = test.model.blocks.at(std::size_t(moved.block));
  const BondLaw& law = *find_bond_law(block.law);
  const Parameter& of_law = law.parameters.at(moved.parameter);
  const std::string where = fmt::format("{}: {} of bonds.{} ({}){}", parameter.name, of_law.name, moved.block,
                                        law.name, test.name.empty() ? "" : " of " + test.name);
  if (of_law.whole || of_law.truth) {
    faults.push_back({{}, where + " is no number that can change a little", "leave it out"});
    return;
  }
  if (std::isnan(block.parameters.at(moved.parameter)))
    faults.push_back({{},
                      where + " is not given there, but in another way",
                      fmt::format("give {} in the block, or calibrate what the block has", of_law.name)});
  const bool too_low =
      of_law.lower_included ? parameter.lower < of_law.lower : parameter.lower <= of_law.lower;
  if (too_low)
    faults.push_back(
        {{},
         fmt::format("{} must be {} {}, the lower bound is {}", where,
                     of_law.lower_included ? "at least" : "greater than", of_law.lower, parameter.lower),
         "raise the lower bound"});
  if (parameter.upper > of_law.upper)
    faults.push_back(
        {{},
         fmt::format("{} must be at most {}, the upper bound is {}", where, of_law.upper, parameter.upper),
         fmt::format("lower the upper bound to {}", of_law.upper)});
}

}  // namespace

void check_parameters(const std::vector<CalibrationTest>& tests,
                      const std::vector<CalibrationParameter>& parameters, std::vector<Fault>& faults) {
  if (parameters.empty())
    faults.push_back({{}, "there are no parameters", "say which parameters of the bonds may move"});
  for (const CalibrationTest& test : tests)
    if (test.parameters.size() != parameters.size())
      faults.push_back({{},
                        fmt::format("test \"{}\" says of {} parameters what they are in it, there are {}",
                                    test.name, test.parameters.size(), parameters.size()),
                        "give a list, maybe empty, for each parameter"});
  if (!faults.empty()) return;

  for (std::size_t p = 0; p < parameters.size(); ++p) {
    check_range(parameters[p], faults);
    bool somewhere = false;
    for (const CalibrationTest& test : tests)
      for (const BlockParameter& moved : test.parameters[p]) {
        somewhere = true;
        check_law(test, moved, parameters[p], faults);
      }
    if (!somewhere)
      faults.push_back({{},
                        fmt::format("{}: no test has this parameter", parameters[p].name),
                        "name one that a [[bonds]] block has"});
  }
  for (const CalibrationTest& test : tests) {
    std::map<std::pair<Index, std::size_t>, std::size_t> owner;
    for (std::size_t p = 0; p < parameters.size(); ++p)
      for (const BlockParameter& moved : test.parameters[p]) {
        const auto [first, is_new] = owner.insert({{moved.block, moved.parameter}, p});
        if (!is_new)
          faults.push_back({{},
                            fmt::format("{} and {} both move the same parameter of bonds.{}{}",
                                        parameters[first->second].name, parameters[p].name, moved.block,
                                        test.name.empty() ? "" : " of " + test.name),
                            "keep one of them"});
      }
  }
}

}  // namespace bondstatic
