#include "report/sweep_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bondstatic {

namespace {

constexpr double percent = 100;
constexpr double rounding = 1e-10;  ///< relative differences below are no differences

const SweepKey* key_of_names(const SweepTable& sweep) {
  for (const SweepKey& key : sweep.keys)
    if (!key.is_number() && key.distinct > 1) return &key;
  return nullptr;
}

}  // namespace

SweepReference reference_of(const SweepTable& sweep) {
  SweepReference reference{"", std::vector<std::size_t>(sweep.rows(), sweep.rows())};
  const SweepKey* key = key_of_names(sweep);
  if (!key) return reference;
  const auto beam = std::find(key->texts.begin(), key->texts.end(), "timoshenko");
  const auto at = std::size_t((beam == key->texts.end() ? key->texts.begin() : beam) - key->texts.begin());
  reference.name = fmt::format("{} = {}", key->short_name, value_names(*key)[at]);

  // What changes together with the key is part of it.
  std::vector<const SweepKey*> same;
  for (const SweepKey& one : sweep.keys)
    if (&one != key && !depends_on(one, *key)) same.push_back(&one);
  const auto others = [&](std::size_t row) {
    std::vector<std::string> values;
    for (const SweepKey* one : same) values.push_back(one->texts[row]);
    return values;
  };
  std::map<std::vector<std::string>, std::size_t> row_of;
  for (std::size_t row = 0; row < sweep.rows(); ++row)
    if (key->texts[row] == key->texts[at]) row_of.try_emplace(others(row), row);
  for (std::size_t row = 0; row < sweep.rows(); ++row)
    if (const auto found = row_of.find(others(row)); found != row_of.end())
      reference.rows[row] = found->second;
  return reference;
}

std::vector<double> differences(const std::vector<double>& values, const SweepReference& reference) {
  std::vector<double> all(values.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t row = 0; row < values.size(); ++row) {
    const std::size_t with = reference.rows[row];
    if (with < values.size() && with != row && values[with] != 0)
      all[row] = percent * (values[row] / values[with] - 1);
  }
  return all;
}

bool differ(const std::vector<double>& differences) {
  return std::any_of(differences.begin(), differences.end(),
                     [](double value) { return std::abs(value) > percent * rounding; });
}

}  // namespace bondstatic
