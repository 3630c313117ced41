// `bondstatic laws --strengths`: what a user sees of the strength criteria.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/run_program.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {
namespace {

using test::Ended;
using test::run_program;
using testing::HasSubstr;

TEST(StrengthListing, HasEveryCriterionWithItsParametersAndSource) {
  const Ended text = run_program({"laws", "--strengths"});
  const auto json = nlohmann::json::parse(run_program({"laws", "--strengths", "--json"}).out);
  EXPECT_EQ(text.code, 0);
  ASSERT_EQ(json.size(), strength_criteria().size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const StrengthCriterion& criterion = strength_criteria()[i];
    EXPECT_THAT(text.out, HasSubstr(criterion.name + "  " + criterion.title));
    for (const std::string& formula : criterion.formulas) EXPECT_THAT(text.out, HasSubstr(formula));
    EXPECT_EQ(json[i]["name"], criterion.name);
    EXPECT_EQ(json[i]["source"], criterion.source);
    EXPECT_EQ(json[i]["modes"], criterion.modes);
    EXPECT_EQ(json[i]["needs_section"], criterion.needs_section);
    ASSERT_EQ(json[i]["parameters"].size(), criterion.parameters.size());
    std::size_t scattering = 0;
    for (std::size_t p = 0; p < criterion.parameters.size(); ++p) {
      const Parameter& parameter = criterion.parameters[p];
      EXPECT_EQ(json[i]["parameters"][p]["name"], parameter.name);
      EXPECT_EQ(json[i]["parameters"][p]["unit"], si_unit(parameter.dimension));
      EXPECT_THAT(text.out, HasSubstr(parameter.meaning));
      if (criterion.scatters[p]) {
        EXPECT_EQ(json[i]["scatters"][scattering++], parameter.name);
      }
    }
    EXPECT_EQ(json[i]["scatters"].size(), scattering);
  }
}

TEST(StrengthListing, GivesOneCriterion) {
  const auto json = nlohmann::json::parse(run_program({"laws", "--strengths", "brown", "--json"}).out);
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0]["name"], "brown");
}

TEST(StrengthListing, RefusesWhatItDoesNotKnow) {
  const Ended unknown = run_program({"laws", "--strengths", "browne"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("unknown strength criterion \"browne\"; did you mean \"brown\"?"));
  EXPECT_EQ(run_program({"laws", "--strengths", "--codes"}).code, 2);
}

}  // namespace
}  // namespace bondstatic
