// One scene, put together from the grids of its states.
#pragma once

#include "report/read_grid.hpp"
#include "report/sample.hpp"
#include "report/scene.hpp"

namespace bondstatic {

class SceneReader {
 public:
  /// What is the same in all states comes from the first one.
  SceneReader(const Grid& first, bool si, const SceneLimits& limits, Blocks& blocks);

  const Sample& sample() const { return sample_; }
  /// How many numbers a state makes, before equal columns of several states become one block.
  double numbers_of(const Grid& grid) const;

  /// Throws Error (invalid_input) where the state is of another model than the first.
  void add(const Grid& grid, const SceneState& state);
  PageScene finish();

 private:
  void place(const std::vector<double>& positions);
  void refuse_another_model(const Grid& grid) const;
  void add_columns(const Grid& grid, Grid::Of of, const std::vector<Index>& places,
                   std::vector<PageColumn>& columns, std::vector<BlockRef>& refs);

  bool si_;
  Blocks& blocks_;
  std::string first_;  ///< path
  Sample sample_;
  std::vector<Index> ids_, bond_ids_;  ///< of the rows
  PageScene scene_;
};

}  // namespace bondstatic
