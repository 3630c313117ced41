#include "formats/particle_ids.hpp"

#include <fmt/format.h>

#include "io/table_rows.hpp"

namespace bondstatic {

IdTable table_of_ids(const std::string& of, const std::vector<Index>& ids, const std::vector<int>& lines,
                     const std::string& file, std::vector<Fault>& faults) {
  IdTable table;
  table.expect(Index(ids.size()));
  LimitedFaults limited(faults);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (table.add(ids[i], Index(i))) continue;
    const Index first = *table.position_of(ids[i]);
    if (!limited.add(
            {file, lines[i], 1},
            fmt::format("{} id {} is there twice, first in line {}", of, ids[i], lines[std::size_t(first)]),
            fmt::format("give every {} an id of its own", of)))
      break;
  }
  return table;
}

}  // namespace bondstatic
