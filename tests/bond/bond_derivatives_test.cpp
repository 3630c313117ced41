// Derivatives of all bonds of a block: which bonds follow it, their contact points, and what is refused.
#include "bond/bond_fixture.hpp"
#include "bondstatic/error.hpp"
#include "support/ridders.hpp"

namespace bondstatic {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Unequal particles with gaps between them; bonds take turns at as many equal blocks of one law.
Model polydisperse(const std::string& law, const Inputs& inputs, std::size_t bonds, Index blocks = 1) {
  RandomBonds random;
  Model model;
  for (std::size_t k = 0; k <= bonds; ++k)
    model.particles.push_back({.id = Index(k + 1), .radius = random.uniform(0.1, 0.2)});
  model.blocks.resize(std::size_t(blocks), {.law = law,
                                            .parameters = in_order(*find_bond_law(law), inputs),
                                            .contact_point = {},
                                            .overrides = {}});
  for (std::size_t k = 0; k < bonds; ++k)
    model.bonds.push_back({.id = Index(k + 1),
                           .a = Index(k),
                           .b = Index(k + 1),
                           .branch = random.uniform(0.42, 0.6) * random.direction(),
                           .block = Index(k) % blocks,
                           .in_block = Index(k) / blocks});
  return model;
}

std::size_t position(const std::string& law, const std::string& parameter) {
  return std::size_t(find_bond_law(law)->find(parameter));
}

ParameterDerivative derivatives(const Model& model, const std::string& parameter, Index block = 0) {
  return bond_derivatives(model, block, position(model.blocks[std::size_t(block)].law, parameter));
}

double number(const SectionStiffness& c, int entry) {
  return entry == 0 ? c.kn : entry == 1 ? c.ks : entry == 2 ? c.kt : entry == 3 ? c.kb : c.coupling;
}

/// What `changing`, a number of the model, does to one bond, by differences.
void expect_differences(const Model& model, double& changing, std::size_t bond, const BondDerivative& found) {
  const double x = changing;
  const SectionStiffness now = bond_properties(model)[bond].stiffness;
  for (int entry = 0; entry < 5; ++entry) {
    const auto changed = [&](double value) {
      changing = value;
      return number(bond_properties(model)[bond].stiffness, entry);
    };
    const test::Difference difference = test::ridders(changed, x, 0.05 * x);
    EXPECT_NEAR(number(found.stiffness, entry), difference.value, 1e-11 * std::abs(number(now, entry) / x))
        << "bond " << bond << " entry " << entry;
  }
  changing = x;
}

const Inputs beam{{"young", 7e10}, {"poisson", 0.2}, {"radius_factor", 0.6}};

TEST(BondDerivatives, AreThoseOfTheBlocksBonds) {
  Model model = polydisperse("timoshenko", beam, 9, 3);
  const ParameterDerivative found = derivatives(model, "poisson", 1);
  EXPECT_THAT(found.bonds, ElementsAre(1, 4, 7));
  EXPECT_THAT(found.has_own, ElementsAre(false, false, false));
  for (std::size_t i = 0; i < 3; ++i)
    expect_differences(model, model.blocks[1].parameters[1], std::size_t(found.bonds[i]), found.of_bond[i]);
}

TEST(BondDerivatives, AreAtTheContactPointThatIsAskedFor) {
  for (const ContactPoint point :
       {ContactPoint{}, ContactPoint{ContactPoint::Kind::gap, 0}, ContactPoint{ContactPoint::Kind::beam, 0},
        ContactPoint{ContactPoint::Kind::contact_radii, 1.2}}) {
    Model model = polydisperse("two-segment", beam, 3);
    model.blocks[0].contact_point = point;
    model.blocks[0].fractions = {0.9, not_given, not_given};
    for (const char* parameter : {"young", "poisson", "radius_factor"}) {
      const ParameterDerivative found = derivatives(model, parameter);
      ASSERT_EQ(found.bonds.size(), 3u);
      for (std::size_t k = 0; k < 3; ++k)
        expect_differences(model, model.blocks[0].parameters[position("two-segment", parameter)], k,
                           found.of_bond[k]);
    }
  }
}

TEST(BondDerivatives, SayWhichBondsHaveAValueOfTheirOwn) {
  Model model = polydisperse("timoshenko", beam, 3);
  model.blocks[0].overrides = {{0, {not_given, 2e9, not_given}}};
  const ParameterDerivative found = derivatives(model, "young");
  EXPECT_THAT(found.bonds, ElementsAre(0, 1, 2));
  EXPECT_THAT(found.has_own, ElementsAre(false, true, false));
  expect_differences(model, model.blocks[0].overrides[0][1], 1, found.of_bond[1]);
  expect_differences(model, model.blocks[0].parameters[0], 2, found.of_bond[2]);
}

TEST(BondDerivatives, CountDefaultsAsGiven) {
  const Model model = polydisperse("timoshenko", {{"young", 7e10}, {"poisson", 0.2}}, 2);
  const ParameterDerivative found = derivatives(model, "radius_factor");
  ASSERT_EQ(found.bonds.size(), 2u);
  const double smaller = std::min(model.particles[0].radius, model.particles[1].radius);
  EXPECT_EQ(found.of_bond[0].radius, smaller);
}

TEST(BondDerivatives, AreThereOnlyForBondsToWhichTheParameterIsGiven) {
  Model model = polydisperse("parallel", beam, 3);
  EXPECT_THAT(derivatives(model, "kappa").bonds, IsEmpty());
  EXPECT_THAT(derivatives(model, "radius").bonds, IsEmpty());
  // A bond that says its ratio in other words than its block.
  model.blocks[0].overrides = {{position("parallel", "kappa"), {not_given, 2.5, not_given}}};
  const ParameterDerivative kappa = derivatives(model, "kappa"), poisson = derivatives(model, "poisson");
  EXPECT_THAT(kappa.bonds, ElementsAre(1));
  EXPECT_THAT(kappa.has_own, ElementsAre(true));
  EXPECT_THAT(poisson.bonds, ElementsAre(0, 2));
  EXPECT_THAT(poisson.has_own, ElementsAre(false, false));
}

TEST(BondDerivatives, AreEmptyForABlockWithoutBonds) {
  Model model = polydisperse("timoshenko", beam, 2);
  model.blocks.push_back(model.blocks[0]);
  EXPECT_THAT(derivatives(model, "young", 1).bonds, IsEmpty());
}

std::string refusal(const Model& model, Index block, std::size_t parameter) {
  try {
    bond_derivatives(model, block, parameter);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    return error.what();
  }
  return "none";
}

TEST(BondDerivatives, RefuseWhatIsNoNumberAndSayWhatIs) {
  const Model model = polydisperse("edem-v2", typical_inputs()["edem-v2"], 2);
  const std::string numbers =
      "; derivatives can be taken to normal_stiffness, shear_stiffness, disk_scale, normal_range, "
      "shear_range";
  EXPECT_EQ(refusal(model, 0, 5),
            "bonds.0 (law edem-v2): seed is a whole number, and nothing has a derivative to it" + numbers);
  EXPECT_EQ(refusal(model, 0, 6),
            "bonds.0 (law edem-v2): torque_feedback is true or false, and nothing has a derivative to it" +
                numbers);
  EXPECT_EQ(refusal(model, 0, 7), "bonds.0 (law edem-v2): parameter 7: the law has 7" + numbers);
  EXPECT_EQ(refusal(model, 1, 0), "bonds.1: the model has 1 blocks, counted from 0");
  EXPECT_EQ(refusal(model, -1, 0), "bonds.-1: the model has 1 blocks, counted from 0");
}

TEST(BondDerivatives, RefuseTheBondsThatBondPropertiesRefuses) {
  Model model = polydisperse("timoshenko", beam, 30);
  for (Bond& bond : model.bonds) bond.branch.setZero();
  const auto faults = [&](auto call) {
    std::vector<std::string> out;
    try {
      call();
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults()) out.push_back(to_string(fault));
    }
    return out;
  };
  const auto found = faults([&] { derivatives(model, "young"); });
  EXPECT_EQ(found.size(), 21u);
  EXPECT_EQ(found, faults([&] { bond_properties(model); }));
  model.blocks[0].parameters = {-1, 2};
  EXPECT_EQ(faults([&] { derivatives(model, "young"); }), faults([&] { bond_properties(model); }));
}

TEST(BondDerivatives, RefuseOneBeyondTheRangeOfDoubles) {
  // kt ~ 1 / (1 + nu) is large, and its derivative larger by another 1 / (1 + nu).
  const Model model =
      polydisperse("euler-bernoulli", {{"young", 1e285}, {"poisson", -1 + 0x1p-53}, {"radius", 0.1}}, 1);
  EXPECT_THAT(refusal(model, 0, 1), AllOf(HasSubstr("bond 1 between particles 1 and 2"),
                                          HasSubstr("the derivative to poisson = -0.99"),
                                          HasSubstr("exceeds the range of doubles")));
  EXPECT_EQ(refusal(model, 0, 0), "none");
}

TEST(BondDerivatives, DoNotDependOnTheNumberOfThreads) {
  Model model = polydisperse("two-segment", beam, 40000);
  model.blocks[0].contact_point = {ContactPoint::Kind::gap, 0};
  std::vector<double>& own = model.blocks[0].overrides[1];
  for (std::size_t k = 0; k < model.bonds.size(); ++k) own.push_back(k % 3 == 0 ? 0.3 : not_given);
  const ParameterDerivative one = bond_derivatives(model, 0, 2, 1), four = bond_derivatives(model, 0, 2, 4);
  ASSERT_EQ(one.bonds, four.bonds);
  EXPECT_EQ(one.has_own, four.has_own);
  for (std::size_t i = 0; i < one.bonds.size(); ++i) {
    for (int entry = 0; entry < 5; ++entry)
      ASSERT_EQ(number(one.of_bond[i].stiffness, entry), number(four.of_bond[i].stiffness, entry));
    ASSERT_EQ(one.of_bond[i].radius, four.of_bond[i].radius);
  }
}

}  // namespace
}  // namespace bondstatic
