#include "report/force_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/column_meaning.hpp"
#include "report/rose.hpp"

namespace bondstatic {

namespace {

using Of = Grid::Of;

constexpr int bins_of_histogram = 41;

struct Bonds {
  std::vector<Vector3> branch;
  std::vector<double> normal_force;  ///< NaN where left out
  std::vector<bool> broken;
};

Bonds read_bonds(const Grid& grid, const std::vector<double>& positions) {
  Bonds bonds;
  const std::vector<Index> ends = grid.ends();
  for (std::size_t k = 0; k < ends.size(); k += 2)
    bonds.branch.push_back(Eigen::Map<const Vector3>(&positions[std::size_t(3 * ends[k + 1])]) -
                           Eigen::Map<const Vector3>(&positions[std::size_t(3 * ends[k])]));
  bonds.normal_force = grid.numbers(Of::lines, "normal_force");
  bonds.broken.resize(bonds.branch.size());
  if (grid.has(Of::lines, "break_step")) {
    const std::vector<Index> steps = grid.whole_numbers(Of::lines, "break_step");
    std::transform(steps.begin(), steps.end(), bonds.broken.begin(), [](Index step) { return step > 0; });
  }
  return bonds;
}

/// Numbers of a sign in bins of a width; the first begins at zero.
struct Side {
  std::vector<double> counts;
  Index bonds = 0;
  double sum = 0;

  Side(double largest, double width)
      : counts(std::size_t(std::max(1.0, std::ceil(largest / width * (1 - 1e-12))))) {}
  void add(double magnitude, double width) {
    ++counts[std::min(counts.size() - 1, std::size_t(magnitude / width))];
    ++bonds;
    sum += magnitude;
  }
  std::string text(const char* name, const std::string& unit) const {
    if (bonds == 0) return fmt::format("no {}", name);
    return fmt::format("{} in {} bonds, mean {:.4g}{}", name, bonds, sum / double(bonds), unit);
  }
};

PageSeries bars(const char* name, const Side& side, double width) {
  PageSeries series{.name = name, .x = {}, .y = side.counts, .draw = PageSeries::Draw::bars};
  for (std::size_t bin = 0; bin < side.counts.size(); ++bin) series.x.push_back((double(bin) + 0.5) * width);
  return series;
}

void add_histogram(const Bonds& bonds, const std::string& of_case, const std::string& unit,
                   std::vector<PagePlot>& plots) {
  double most = 0, least = 0;
  for (const double force : bonds.normal_force) {
    most = std::max(most, force);
    least = std::min(least, force);
  }
  const double width = (most - least) / bins_of_histogram;
  if (!(width > 0) || !std::isfinite(width)) return;
  Side tension(most, width), compression(-least, width);
  Index none = 0;
  for (const double force : bonds.normal_force) {
    if (force > 0) tension.add(force, width);
    if (force < 0) compression.add(-force, width);
    none += !(force > 0) && !(force < 0);
  }
  PageSeries in_tension = bars("tension", tension, width),
             in_compression = bars("compression", compression, width);
  for (double& x : in_compression.x) x = -x;
  std::reverse(in_compression.x.begin(), in_compression.x.end());
  std::reverse(in_compression.y.begin(), in_compression.y.end());
  const std::string space = unit.empty() ? "" : " " + unit;
  PagePlot plot{.title = "Normal forces of bonds" + of_case,
                .x = {.label = "normal force", .unit = unit},
                .y = {.label = "bonds"},
                .series = {}};
  if (compression.bonds > 0) plot.series.push_back(std::move(in_compression));
  if (tension.bonds > 0) plot.series.push_back(std::move(in_tension));
  // Forces concentrate about cracks and notches: a bar of nearly all bonds would leave the others no height.
  const auto most_in = [](const Side& side) {
    return *std::max_element(side.counts.begin(), side.counts.end());
  };
  plot.y.log =
      std::max(most_in(tension), most_in(compression)) > 0.5 * double(tension.bonds + compression.bonds) &&
      tension.bonds + compression.bonds >= 100;
  plot.note = fmt::format("{}; {}", tension.text("tension", space), compression.text("compression", space));
  if (none > 0) plot.note += fmt::format("; {} bonds carry none", none);
  plots.push_back(std::move(plot));
}

constexpr const char* axis_names = "xyz";

/// Extents of the model, 0 where they are rounding.
Vector3 extents(const std::vector<double>& positions) {
  if (positions.empty()) return Vector3::Zero();
  const Eigen::Map<const Eigen::Matrix3Xd> points(positions.data(), 3, Index(positions.size() / 3));
  const Vector3 extent = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  return (extent.array() > 1e-9 * extent.maxCoeff()).select(extent, 0);
}

PagePlot rose_plot(const std::string& title, std::array<int, 2> plane, const char* name, PageAxis y,
                   std::vector<double> petals) {
  PageSeries series{.name = name, .x = rose_angles(), .y = std::move(petals), .draw = PageSeries::Draw::bars};
  const char right = axis_names[plane[0]], up = axis_names[plane[1]];
  return {.title = fmt::format("{}, {}{} plane", title, right, up),
          .kind = PagePlot::Kind::rose,
          .x = {.label = fmt::format("from {} towards {}", right, up), .unit = "°"},
          .y = std::move(y),
          .series = {std::move(series)},
          .note =
              "Bonds projected onto the plane, each in both of its directions; those within 6 degrees of "
              "its normal have no direction in it and are left out."};
}

void add_roses(const Bonds& bonds, std::array<int, 2> plane, const std::string& of_case, bool with_directions,
               const std::string& unit, std::vector<PagePlot>& plots) {
  Rose carrying, broken;
  for (std::size_t k = 0; k < bonds.branch.size(); ++k) {
    const double force = bonds.normal_force[k];
    if (std::isnan(force)) continue;
    (bonds.broken[k] ? broken : carrying).add(bonds.branch[k], plane, std::abs(force));
  }
  if (with_directions && carrying.bonds() > 0)
    plots.push_back(rose_plot("Directions of bonds", plane, "bonds", {.label = "bonds"}, carrying.counts()));
  if (with_directions && broken.bonds() > 0)
    plots.push_back(rose_plot("Directions of broken bonds", plane, "broken bonds", {.label = "broken bonds"},
                              broken.counts()));
  if (carrying.bonds() > 0)
    plots.push_back(rose_plot("Mean size of the normal force" + of_case, plane, "mean |normal force|",
                              {.label = "mean |normal force|", .unit = unit}, carrying.means()));
}

}  // namespace

void add_force_plots(const Grid& grid, const std::string& load_case, bool with_directions, bool si,
                     std::vector<PagePlot>& plots) {
  if (grid.count(Of::lines) == 0 || !grid.has(Of::lines, "normal_force")) return;
  const std::vector<double> positions = grid.positions();
  const Bonds bonds = read_bonds(grid, positions);
  const std::string of_case = load_case.empty() ? "" : ", load case " + load_case;
  const std::string unit = unit_of("normal_force", si);
  add_histogram(bonds, of_case, unit, plots);
  const Vector3 extent = extents(positions);
  for (const std::array<int, 2> plane : {std::array{0, 1}, {0, 2}, {1, 2}})
    if (extent[plane[0]] > 0 && extent[plane[1]] > 0)
      add_roses(bonds, plane, of_case, with_directions, unit, plots);
}

}  // namespace bondstatic
