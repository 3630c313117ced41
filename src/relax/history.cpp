#include "relax/history.hpp"

#include "io/archive.hpp"

namespace bondstatic {

namespace {

constexpr std::size_t most_rows = 4096;

void keep_every_second(std::vector<double>& values) {
  for (std::size_t i = 0; 2 * i < values.size(); ++i) values[i] = values[2 * i];
  values.resize((values.size() + 1) / 2);
}

}  // namespace

void describe(Archive& archive, HistoryColumn& column) {
  archive(column.name, column.values);
}

void History::add(const Probes& row) {
  if (columns_.empty())
    for (const auto& [name, value] : row) columns_.push_back({name, {}});
  for (std::size_t c = 0; c < row.size(); ++c) columns_.at(c).values.push_back(row[c].second);
  // Rows stand at looks 0, every, 2 every ...; an odd number leaves the last of them on the new grid.
  if (columns_.empty() || columns_.front().values.size() <= most_rows) return;
  for (HistoryColumn& column : columns_) keep_every_second(column.values);
  every_ *= 2;
}

void History::carry(Archive& archive) {
  archive(columns_, every_);
}

}  // namespace bondstatic
