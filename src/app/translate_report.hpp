// What `translate` answers, as a user reads it and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bond/translate.hpp"
#include "bondstatic/case_file.hpp"
#include "bondstatic/check.hpp"
#include "bondstatic/output.hpp"

namespace bondstatic {

/// The answer of the model with some of the code's conventions, against that of the model as it is.
struct ConventionEffect {
  std::vector<std::vector<FieldDifference>> fields;  ///< [load case][field]
  std::vector<OutputValue> outputs;
};

struct TranslationEffects {
  std::vector<std::string> load_cases;
  std::vector<OutputValue> outputs;  ///< of the model as it is
  ConventionEffect contact_point, stiffness, both;
};

/// No effects where nothing acts on the model. `written`: the files, none if nothing was written.
std::string translation_report(const Case& given, const Translation& translation,
                               const std::vector<BlockFit>& fits,
                               const std::optional<TranslationEffects>& effects,
                               const std::vector<std::string>& written);
std::string translation_json(const Case& given, const Translation& translation,
                             const std::vector<BlockFit>& fits,
                             const std::optional<TranslationEffects>& effects);

}  // namespace bondstatic
