#include "report/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "bondstatic/error.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {

namespace {

/// Where the counts begin: `sweep` writes keys, particles, bonds, outputs, status. Outputs may be called so,
/// too.
int place_of_counts(const std::vector<std::string>& names) {
  for (std::size_t i = 1; i + 2 < names.size(); ++i)
    if (names[i] == "particles" && names[i + 1] == "bonds") return int(i);
  return -1;
}

std::string without_quotes(const std::string& text) {
  const bool quoted =
      text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

/// "50 GPa" as 50 and "GPa"; false where it does not begin with a number.
bool split_number(const std::string& text, double& number, std::string& unit) {
  const char *begin = text.data() + text.starts_with('+'), *end = text.data() + text.size();
  const auto read = std::from_chars(begin, end, number);
  if (read.ec != std::errc() || !std::isfinite(number)) return false;
  const std::size_t at = text.find_first_not_of(' ', std::size_t(read.ptr - text.data()));
  unit = at == std::string::npos ? "" : text.substr(at);
  return true;
}

/// Numbers with underscores (1_000) are left to be names, as are mixed units.
void find_numbers(SweepKey& key) {
  std::vector<double> numbers(key.texts.size());
  for (std::size_t row = 0; row < key.texts.size(); ++row) {
    std::string unit;
    if (!split_number(key.texts[row], numbers[row], unit)) return;
    if (row > 0 && unit != key.unit) {
      key.unit.clear();
      return;
    }
    key.unit = unit;
  }
  key.numbers = std::move(numbers);
}

std::string last_part(const std::string& name) {
  return name.substr(name.rfind('.') + 1);
}

void name_shortly(std::vector<SweepKey>& keys) {
  std::map<std::string, int> times;
  for (const SweepKey& key : keys) ++times[last_part(key.name)];
  for (SweepKey& key : keys) {
    const std::string part = last_part(key.name);
    const bool says_something = part.find_first_not_of("0123456789") != std::string::npos;
    key.short_name = says_something && times[part] == 1 ? part : key.name;
  }
}

/// The entries of "{ law = "parallel", kappa = 2 }"; the whole text where it is none.
std::vector<std::string> entries_of(const std::string& text) {
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') return {text};
  std::vector<std::string> entries(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text.substr(1, text.size() - 2)) {
    if (c == '"') quoted = !quoted;
    if (!quoted) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == ',' && depth == 0 && !quoted)
      entries.emplace_back();
    else if (c != ' ' || !entries.back().empty())
      entries.back() += c;
  }
  for (std::string& entry : entries) entry.erase(entry.find_last_not_of(' ') + 1);
  return entries;
}

}  // namespace

SweepTable read_sweep(const std::string& file, const CsvColumns& csv) {
  SweepTable table;
  table.columns = csv.names();
  const char* cure = "let `bondstatic sweep CASE --vary KEY=v1,v2 --out DIR` write it anew";
  if (table.columns.size() < 2 || table.columns.back() != "status")
    throw InputError({{{file, 1, 1},
                       fmt::format("the last column is {} where status must be", table.columns.back()),
                       cure}});
  const int last = int(table.columns.size()) - 1, counts = place_of_counts(table.columns);
  if (counts < 0)
    throw InputError({{{file, 1, 1},
                       fmt::format("there are no columns particles and bonds behind the keys, but {}",
                                   name_list(table.columns)),
                       cure}});
  const auto name = [&](int column) { return table.columns[std::size_t(column)]; };
  table.status = csv.texts(last);
  for (int column = 0; column < counts; ++column) {
    SweepKey key{name(column), "", csv.texts(column), {}, "", 0};
    for (std::string& text : key.texts) text = without_quotes(text);
    key.distinct = std::set<std::string>(key.texts.begin(), key.texts.end()).size();
    find_numbers(key);
    table.keys.push_back(std::move(key));
  }
  name_shortly(table.keys);
  table.counts = {SweepColumn{"number of particles", csv.numbers(counts)},
                  SweepColumn{"number of bonds", csv.numbers(counts + 1)}};
  for (int column = counts + 2; column < last; ++column)
    table.outputs.push_back({name(column), csv.numbers(column)});
  return table;
}

bool depends_on(const SweepKey& of, const SweepKey& on) {
  std::map<std::string, std::string> value;
  for (std::size_t row = 0; row < of.texts.size(); ++row)
    if (value.try_emplace(on.texts[row], of.texts[row]).first->second != of.texts[row]) return false;
  return true;
}

std::vector<std::string> value_names(const SweepKey& key) {
  std::map<std::string, std::size_t> times;
  const std::set<std::string> values(key.texts.begin(), key.texts.end());
  for (const std::string& value : values)
    for (const std::string& entry : entries_of(value)) ++times[entry];
  std::vector<std::string> names;
  for (const std::string& text : key.texts) {
    std::string name;
    for (const std::string& entry : entries_of(text))
      if (values.size() == 1 || times[entry] < values.size()) name += (name.empty() ? "" : ", ") + entry;
    names.push_back(name.empty() ? text : name);
  }
  return names;
}

}  // namespace bondstatic
