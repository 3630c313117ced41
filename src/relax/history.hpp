// Rows of numbers over time, as many as a plot needs and no more.
#pragma once

#include "bondstatic/relaxation.hpp"

namespace bondstatic {

class Archive;

class History {
 public:
  /// Whether this look belongs in the history: every so many of them.
  bool wants(Index look) const { return look % every_ == 0; }

  /// One row; the names are those of the first. Where the rows become too many every second one is dropped,
  /// and only half as many looks are wanted from then on.
  void add(const Probes& row);

  const std::vector<HistoryColumn>& columns() const { return columns_; }
  void carry(Archive& archive);

 private:
  std::vector<HistoryColumn> columns_;
  Index every_ = 1;
};

}  // namespace bondstatic
