#include "system/together.hpp"

#include <cmath>
#include <vector>

namespace bondstatic {

double largest_of_all(Ranks* ranks, double mine) {
  if (!ranks) return mine;
  double largest = mine;
  for (const double one : ranks->all_gather({&mine, 1}))
    if (one > largest || std::isnan(one)) largest = one;
  return largest;
}

void add_up(Ranks* ranks, std::span<Extended> mine) {
  if (!ranks) return;
  std::vector<double> halves;
  for (const Extended& value : mine) halves.insert(halves.end(), {value.x[0], value.x[1]});
  const std::vector<double> all = ranks->all_gather(halves);
  for (std::size_t i = 0; i < mine.size(); ++i) {
    mine[i] = 0.0;
    for (std::size_t at = 2 * i; at < all.size(); at += halves.size())
      mine[i] += Extended(all[at], all[at + 1]);
  }
}

double sum_of_all(Ranks* ranks, double mine) {
  Extended sum = mine;
  add_up(ranks, {&sum, 1});
  return to_double(sum);
}

}  // namespace bondstatic
