#include "report/fracture_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "report/page_parts.hpp"

namespace bondstatic {

namespace {

const double nan = std::nan("");

/// Each event as it happens: to the point where its bonds reach their strength, and to where the load falls
/// when they are gone.
void add_events(PageSeries& path, const FractureHistory& history, std::size_t first, std::size_t last) {
  for (std::size_t e = first; e <= last; ++e) {
    const BreakEvent& event = history.events[e];
    path.x.push_back(event.displacement);
    path.y.push_back(event.load);
    path.x.push_back(event.displacement_after);
    path.y.push_back(event.load_after);
  }
}

/// The avalanches with most bonds, in their order; those of one bond are no avalanches to be shown.
std::vector<BreakAvalanche> largest_avalanches(const FractureHistory& history) {
  constexpr std::size_t most = 5;
  std::vector<BreakAvalanche> all = history.avalanches;
  std::erase_if(all, [](const BreakAvalanche& one) { return one.broken < 2; });
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.broken > b.broken; });
  if (all.size() > most) all.resize(most);
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return all;
}

PageMark mark_at(const BreakEvent& event, const std::string& label) {
  return {event.displacement, event.load, label};
}

PagePlot load_plot(const FractureHistory& history, const CurveWords& words, bool from_zero,
                   const PageUnits& units) {
  const std::string name = words.load + " over " + words.displacement;
  PagePlot plot{char(std::toupper(name.front())) + name.substr(1),
                PagePlot::Kind::xy,
                units.axis(words.displacement, words.displacement_unit),
                units.axis(words.load, words.load_unit),
                {}};
  PageSeries path{"as it happens", {}, {}, PageSeries::Draw::line};
  if (from_zero) {
    path.x.push_back(0);
    path.y.push_back(0);
  }
  add_events(path, history, 0, history.events.size() - 1);
  plot.series.push_back(std::move(path));
  PageSeries breaks{"bonds break", {}, {}, PageSeries::Draw::points};
  for (const BreakEvent& event : history.events) {
    breaks.x.push_back(event.displacement);
    breaks.y.push_back(event.load);
  }
  for (const BreakAvalanche& avalanche : largest_avalanches(history)) {
    PageSeries series{fmt::format("avalanche {} of {}", history.events[avalanche.first].avalanche,
                                  count_text(avalanche.broken, "bond")),
                      {},
                      {},
                      PageSeries::Draw::line};
    add_events(series, history, avalanche.first, avalanche.last);
    plot.series.push_back(std::move(series));
  }
  plot.series.push_back(std::move(breaks));
  const auto peak =
      std::max_element(history.events.begin(), history.events.end(),
                       [](const BreakEvent& a, const BreakEvent& b) { return a.load < b.load; });
  const BreakEvent& first = history.events.front();
  if (peak == history.events.begin()) {
    plot.marks.push_back(mark_at(first, "first break, at the peak: " + first.bonds));
  } else {
    plot.marks.push_back(mark_at(first, "first break: " + first.bonds));
    plot.marks.push_back(
        mark_at(*peak, fmt::format("peak, after {}", count_text(peak - history.events.begin(), "event"))));
  }
  plot.note =
      "Straight on to where bonds reach their strength; when they are gone, down at what is controlled.";
  return plot;
}

PagePlot over_steps(const FractureHistory& history, const std::string& title, const PageAxis& y,
                    const std::vector<std::pair<std::string, double BreakEvent::*>>& of,
                    PageSeries::Draw draw) {
  PagePlot plot{title, PagePlot::Kind::xy, {"event"}, y, {}};
  for (const auto& [name, member] : of) {
    PageSeries series{name, {}, {}, draw};
    for (const BreakEvent& event : history.events) {
      series.x.push_back(event.step);
      series.y.push_back(event.*member);
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

void put_avalanches(std::vector<PagePlot>& plots, const FractureHistory& history) {
  PagePlot sizes{"Bonds broken by each avalanche", PagePlot::Kind::xy, {"avalanche"}, {"bonds"}, {}};
  PageSeries series{"bonds", {}, {}, PageSeries::Draw::bars};
  for (const BreakAvalanche& avalanche : history.avalanches) {
    series.x.push_back(double(history.events[avalanche.first].avalanche));
    series.y.push_back(double(avalanche.broken));
  }
  sizes.series.push_back(series);
  sizes.y.log = wants_log(sizes.series);
  // From 1 up, a bar on a log axis has nowhere to stand.
  if (sizes.y.log) sizes.series.front().draw = PageSeries::Draw::points;
  put_plot(plots, std::move(sizes));

  std::vector<double> ascending = series.y;
  std::sort(ascending.begin(), ascending.end());
  PageSeries larger{"avalanches", {}, {}, PageSeries::Draw::line_and_points};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    if (i > 0 && ascending[i] == ascending[i - 1]) continue;
    larger.x.push_back(ascending[i]);
    larger.y.push_back(double(ascending.size() - i));
  }
  constexpr std::size_t telling = 4;
  if (larger.x.size() >= telling)
    put_plot(plots, {"Sizes of avalanches",
                     PagePlot::Kind::xy,
                     {"bonds", "", true},
                     {"avalanches of so many bonds or more", "", true},
                     {std::move(larger)}});
}

}  // namespace

void put_fracture_plots(std::vector<PagePlot>& plots, const FractureHistory& history, const CurveWords& words,
                        bool from_zero, bool si) {
  if (history.events.empty()) return;
  const PageUnits units{si};
  using Draw = PageSeries::Draw;
  put_plot(plots, load_plot(history, words, from_zero, units));
  put_avalanches(plots, history);
  put_plot(plots, over_steps(history, "Energies after each event", units.axis("energy", "J"),
                             {{"work", &BreakEvent::work},
                              {"strain", &BreakEvent::strain_energy},
                              {"dissipated", &BreakEvent::dissipated}},
                             Draw::line));
  PagePlot released = over_steps(history, "Energy that each event releases", units.axis("energy", "J"),
                                 {{"released", &BreakEvent::released}}, Draw::points);
  released.y.log = wants_log(released.series);
  put_plot(plots, std::move(released));
  put_plot(plots, over_steps(history, "How near the next bond is", {"utilisation"},
                             {{"largest among the bonds that stay", &BreakEvent::runner_up}}, Draw::points));
  const std::string load = words.load + " at each event";
  put_plot(plots, over_steps(history, char(std::toupper(load.front())) + load.substr(1),
                             units.axis(words.load, words.load_unit), {{words.load, &BreakEvent::load}},
                             Draw::line_and_points));
  PageSeries broken{"broken bonds", {}, {}, Draw::steps};
  for (const BreakEvent& event : history.events) {
    broken.x.push_back(event.displacement);
    broken.y.push_back((broken.y.empty() ? 0 : broken.y.back()) + double(event.broken));
  }
  put_plot(plots, {"Broken bonds over " + words.displacement,
                   PagePlot::Kind::xy,
                   units.axis(words.displacement, words.displacement_unit),
                   {"bonds"},
                   {std::move(broken)}});
  for (std::size_t i = 0; i < history.outputs.size(); ++i) {
    PageSeries series{"just before each event", {}, {}, Draw::line_and_points};
    for (const BreakEvent& event : history.events) {
      series.x.push_back(event.step);
      series.y.push_back(i < event.outputs.size() ? event.outputs[i] : nan);
    }
    put_plot(plots, {history.outputs[i] + " over events",
                     PagePlot::Kind::xy,
                     {"event"},
                     {history.outputs[i]},
                     {std::move(series)}});
  }
}

}  // namespace bondstatic
