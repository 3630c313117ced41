#include "app/translate_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/report.hpp"
#include "app/terminal.hpp"
#include "bondstatic/results.hpp"

namespace bondstatic {

namespace {

constexpr const char* stiffness_names[] = {"kn", "ks", "kt", "kb"};

std::string value_text(const CodeParameter& parameter, double lowest, double highest) {
  if (parameter.truth)
    return lowest != highest ? "true and false, see bonds.csv" : lowest != 0 ? "true" : "false";
  // What differs by rounding alone is one value to a reader.
  if (highest - lowest <= exact_fit * std::abs(highest)) return fmt::format("{:.10g}", highest);
  return fmt::format("{:.7g} ... {:.7g}", lowest, highest);
}

/// "kn, ks, kb exactly; kt to 5.6e-02".
std::string carried(const BlockFit& fit) {
  std::string exact, others;
  for (std::size_t i = 0; i < fit.misfit.size(); ++i) {
    if (fit.misfit[i] <= exact_fit)
      exact += (exact.empty() ? "" : ", ") + std::string(stiffness_names[i]);
    else
      others += (others.empty() ? "" : ", ") +
                (std::isinf(fit.misfit[i])
                     ? fmt::format("{} where none is wanted", stiffness_names[i])
                     : fmt::format("{} off by at most {:.2g} of it", stiffness_names[i], fit.misfit[i]));
  }
  if (!exact.empty()) exact += " exactly";
  return exact + (exact.empty() || others.empty() ? "" : "; ") + others;
}

std::string block_text(const Case& given, std::size_t block, const BondCode& code, const BlockFit& fit) {
  std::string text =
      fmt::format("bonds.{} ({}), {}\n", block, given.model.blocks[block].law, counted(fit.bonds, "bond"));
  TextTable values{{}, {false, true, false, false}};
  for (std::size_t p = 0; p < code.stored.size(); ++p)
    values.rows.push_back({code.stored[p].name, value_text(code.stored[p], fit.lowest[p], fit.highest[p]),
                           given.si ? si_unit(code.stored[p].dimension) : "", code.stored[p].input});
  text += to_text(values, 4);
  const auto line = [&](const char* what, const std::string& said) {
    text += fmt::format("  {:<15}{}\n", what, wrapped(said, 17));
  };
  line("carried", carried(fit));
  if (fit.coupled > 0)
    line("lost", fmt::format("coupling of shear and bending in {}", counted(fit.coupled, "bond")));
  line("contact point",
       fit.moved == 0 ? "as in the case" : fmt::format("moved by at most {:.3g} of the length", fit.moved));
  if (fit.departing > 0)
    line("beyond this", fmt::format("{}, by at most {:.3g}: {}", counted(fit.departing, "bond"),
                                    fit.departure, code.departure_text));
  return text + "\n";
}

std::string at_text(const Model& model, const FieldDifference& difference) {
  const Worst& worst = difference.worst;
  if (worst.at < 0) return "";
  const auto at = std::size_t(worst.at);
  return worst.of_bond ? fmt::format("bond {}", model.bonds[at].id)
                       : fmt::format("particle {}", model.particles[at].id);
}

std::string fields_text(const Case& given, const TranslationEffects& effects, bool departs) {
  std::string text = "relative change of the answer with the code's contact point, its stiffness, both\n";
  if (departs)
    text += "(the code's own change is another: what it does beyond this, see above, is not counted)\n";
  TextTable table{{{"", "contact point", "", "stiffness", "", "both", "", ""},
                   {"", "norm", "largest", "norm", "largest", "norm", "largest", "largest at"}},
                  {false, true, true, true, true, true, true, false}};
  for (std::size_t c = 0; c < effects.load_cases.size(); ++c) {
    if (!effects.load_cases[c].empty()) table.rows.push_back({effects.load_cases[c]});
    for (std::size_t f = 0; f < effects.both.fields[c].size(); ++f) {
      std::vector<std::string> row{effects.both.fields[c][f].field};
      for (const ConventionEffect* effect : {&effects.contact_point, &effects.stiffness, &effects.both})
        for (const double part : {effect->fields[c][f].norm, effect->fields[c][f].largest})
          row.push_back(fmt::format("{:.1e}", part));
      row.push_back(at_text(given.model, effects.both.fields[c][f]));
      table.rows.push_back(std::move(row));
    }
  }
  return text + to_text(table, 2);
}

double relative_change(double here, double there) {
  return here == there ? 0 : std::abs(there - here) / std::abs(here);
}

std::string outputs_text(const TranslationEffects& effects) {
  if (effects.outputs.empty()) return "";
  TextTable table{{{"output", "as it is", "contact point", "stiffness", "both", "relative change"}},
                  {false, true, true, true, true, true}};
  for (std::size_t i = 0; i < effects.outputs.size(); ++i) {
    const double here = effects.outputs[i].value, there = effects.both.outputs[i].value;
    table.rows.push_back({effects.outputs[i].name, fmt::format("{:.10g}", here),
                          fmt::format("{:.10g}", effects.contact_point.outputs[i].value),
                          fmt::format("{:.10g}", effects.stiffness.outputs[i].value),
                          fmt::format("{:.10g}", there),
                          fmt::format("{:.1e}", relative_change(here, there))});
  }
  return "\n" + to_text(table, 2);
}

}  // namespace

std::string translation_report(const Case& given, const Translation& translation,
                               const std::vector<BlockFit>& fits,
                               const std::optional<TranslationEffects>& effects,
                               const std::vector<std::string>& written) {
  const BondCode& code = *translation.code;
  std::string text = heading(given, facts_of(given.model)) + "\n";
  text += fmt::format("to {}  {}\n\n", bold(code.name, stdout), code.title);
  for (std::size_t b = 0; b < fits.size(); ++b)
    if (fits[b].bonds > 0) text += block_text(given, b, code, fits[b]);
  const bool departs =
      std::any_of(fits.begin(), fits.end(), [](const BlockFit& fit) { return fit.departing > 0; });
  if (effects)
    text += fields_text(given, *effects, departs) + outputs_text(*effects);
  else
    text += "nothing acts on the model: no answer to compare\n";
  TextTable notes{{{"rule", wrapped(code.fit, 17)},
                   {"contact point", wrapped(code.contact_point_text + " (" + code.known_from + ")", 17)}},
                  {}};
  for (const std::string& remark : code.remarks) notes.rows.push_back({"mind", wrapped(remark, 17)});
  if (!written.empty())
    notes.rows.push_back({"written", wrapped(fmt::format("{}", fmt::join(written, ", ")), 17)});
  return text + "\n" + to_text(notes, 2) + warnings_text(given.warnings);
}

}  // namespace bondstatic
