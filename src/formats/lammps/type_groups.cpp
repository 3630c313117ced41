#include "formats/lammps/type_groups.hpp"

#include <fmt/format.h>

#include <map>

namespace bondstatic {

void group_by_type(const std::vector<Index>& types, ForeignModel& model) {
  std::map<Index, int> group_of;
  for (const Index type : types) group_of.emplace(type, 0);
  for (auto& [type, group] : group_of) {
    group = int(model.group_names.size());
    model.group_names.push_back(fmt::format("type {}", type));
  }
  model.group.reserve(types.size());
  for (const Index type : types) model.group.push_back(group_of.at(type));
}

}  // namespace bondstatic
