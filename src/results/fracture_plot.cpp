#include "results/fracture_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "results/fracture_words.hpp"

namespace bondstatic {

namespace {

using Point = Eigen::Vector2d;

Point before(const FractureEvent& event) {
  return {event.displacement, event.load};
}

/// Of a specimen that has come apart nothing carries, and what its ends do has no end.
Point after(const FractureEvent& event) {
  return {event.displacement_after, event.load_after};
}

std::map<Index, Index> avalanche_sizes(const Fracture& fracture) {
  std::map<Index, Index> sizes;
  for (const FractureEvent& event : fracture.events) sizes[event.avalanche] += Index(event.bonds.size());
  return sizes;
}

std::vector<PlotDot> dots_of(const Fracture& fracture, const std::map<Index, Index>& sizes) {
  constexpr double small = 1.5, largest = 14;
  std::vector<PlotDot> dots;
  Index avalanche = -1;
  for (const FractureEvent& event : fracture.events) {
    double radius = small;
    if (event.avalanche != avalanche)
      radius = std::min(largest, 2 * std::sqrt(double(sizes.at(event.avalanche))));
    avalanche = event.avalanche;
    dots.push_back({before(event), radius});
  }
  return dots;
}

std::string note_of(const Fracture& fracture, const std::map<Index, Index>& sizes) {
  const auto longer = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto most = std::max_element(sizes.begin(), sizes.end(), longer);
  if (most == sizes.end()) return "no bond broke";
  return fmt::format("{} bonds broken in {} avalanches, {} in the largest (discs); {}",
                     count_breaks(fracture), sizes.size(), most->second, text_of(fracture.end));
}

std::string first_words(const Model& model, const FractureEvent& first) {
  const BrokenBond& broken = first.bonds.front();
  const std::string mode = mode_name(model, broken);
  std::string words = fmt::format("first break: bond {}", model.bonds[std::size_t(broken.bond)].id);
  if (first.bonds.size() > 1) words += fmt::format(" and {} more", first.bonds.size() - 1);
  return words + (mode.empty() ? "" : ", " + mode);
}

}  // namespace

Plot fracture_plot(const Model& model, const RunInfo& run, const FractureOptions& asked,
                   const Fracture& fracture) {
  const FractureWords words = fracture_words(model, asked);
  const auto sizes = avalanche_sizes(fracture);
  Plot plot;
  plot.title = run.title.empty() ? "fracture" : run.title;
  plot.note = note_of(fracture, sizes);
  plot.x = {words.displacement, run.si ? words.displacement_unit : ""};
  plot.y = {words.load, run.si ? words.load_unit : ""};
  // Where a preload displaces, the curve does not begin at zero.
  if (asked.preload < 0) plot.curve.push_back(Point::Zero());
  for (const FractureEvent& event : fracture.events) {
    plot.curve.push_back(before(event));
    plot.curve.push_back(after(event));
  }
  plot.dots = dots_of(fracture, sizes);
  const FractureEvent* peak = peak_of(fracture);
  if (!peak) return plot;
  const FractureEvent* first = &fracture.events.front();
  plot.marks.push_back({before(*first), first_words(model, *first), first == peak});
  if (first == peak)
    plot.marks.front().text += ", at the largest load";
  else
    plot.marks.push_back({before(*peak), fmt::format("largest load, after {} events", peak - first)});
  return plot;
}

}  // namespace bondstatic
