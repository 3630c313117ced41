// The certificate for a real packing: 2068 spheres of YADE, loaded by forces and by a platen. The ratio of
// the run's time to the static solve's stands in the properties of the test report. BONDSTATIC_FULL=1: finite
// kinematics too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "bondstatic/case_file.hpp"
#include "bondstatic/check.hpp"

namespace bondstatic::test {
namespace {

bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

Certificate certificate_of(const std::string& file, const std::string& kinematics) {
  Case given =
      read_case(BONDSTATIC_SOURCE_DIR "/cases/yade-packing/" + file,
                {"particles.0.density=2650", "dynamics.kinematics=" + kinematics}, "", Purpose::dynamics);
  given.solve.threads = 1;
  return check(given.model, given.solve, given.relax);
}

struct Named {
  const char* name;
  const char* file;
};

void PrintTo(const Named& named, std::ostream* out) {
  *out << named.file;
}

const Named loads{"Loads", "loads.toml"}, press{"Press", "press.toml"};

std::vector<Named> with_finite_kinematics() {
  return full_run() ? std::vector{loads, press} : std::vector{press};
}

class YadeCertificate : public ::testing::TestWithParam<Named> {
 protected:
  void tell(const Certificate& certificate) {
    RecordProperty("ratio", fmt::format("{:.3g}", certificate.dynamic_seconds / certificate.static_seconds));
    for (const CaseCertificate& one : certificate.cases)
      RecordProperty("steps_" + one.name, std::to_string(one.run.steps));
  }
};

class SmallKinematics : public YadeCertificate {};
class FiniteKinematics : public YadeCertificate {};

// At rest means 1e-8 of the loads unbalanced; where a part of the packing holds all of that, a few times it.
TEST_P(SmallKinematics, AgreeWithTheStaticAnswer) {
  const Certificate certificate = certificate_of(GetParam().file, "small");
  EXPECT_TRUE(certificate.agrees());
  ASSERT_FALSE(certificate.cases.empty());
  for (const CaseCertificate& one : certificate.cases) {
    EXPECT_LE(one.run.energies.balance(), 1e-13) << one.name;
    for (const FieldDifference& field : one.fields)
      EXPECT_LE(field.largest, 1e-7) << one.name << ", " << field.field;
  }
  tell(certificate);
}

TEST_P(FiniteKinematics, AgreeAtFirstOrder) {
  const Certificate certificate = certificate_of(GetParam().file, "finite");
  EXPECT_TRUE(certificate.agrees());
  ASSERT_FALSE(certificate.cases.empty());
  for (const CaseCertificate& one : certificate.cases)
    for (const FieldDifference& field : one.fields) {
      EXPECT_LE(field.first_order, 1e-6) << one.name << ", " << field.field;
      EXPECT_GT(field.second_order, 1e-6)
          << one.name << ", " << field.field;  // there is something to tell apart
    }
  tell(certificate);
}

const auto name_of = [](const auto& named) { return std::string(named.param.name); };
INSTANTIATE_TEST_SUITE_P(YadeCertificate, SmallKinematics, ::testing::Values(loads, press), name_of);
INSTANTIATE_TEST_SUITE_P(YadeCertificate, FiniteKinematics, ::testing::ValuesIn(with_finite_kinematics()),
                         name_of);

}  // namespace
}  // namespace bondstatic::test
