#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "bondstatic/results.hpp"
#include "results/hand_made.hpp"

namespace bondstatic {
namespace {

FieldDifference difference(const std::string& field, Worst worst) {
  FieldDifference result;
  result.field = field;
  result.largest = 0.25;
  result.norm = 0.125;
  result.worst = worst;
  result.first_order = 1e-9;
  return result;
}

Certificate hand_made_certificate() {
  Certificate certificate;
  certificate.tolerance = 1e-6;
  certificate.static_seconds = 0.5;
  certificate.dynamic_seconds = 20;
  certificate.warnings = {"slow"};
  CaseCertificate one;
  one.name = "push";
  one.agrees = true;
  one.statics.forward_error = 1e-15;
  one.statics.backward_error = 1e-17;
  one.statics.energy_balance = 1e-16;
  one.run.state = test::hand_made_result("push");
  one.run.end = RunEnd::at_rest;
  one.fields = {difference("displacement", {false, 2}), difference("bond force", {true, 1}),
                difference("energy", {})};
  one.fields[0].second_order = 0.2;
  one.fields[1].norm = std::numeric_limits<double>::infinity();
  certificate.cases.push_back(one);
  return certificate;
}

nlohmann::json json_of(const Certificate& certificate) {
  const RunInfo info{"a title", "case.toml", "", true, {"careful"}};
  return nlohmann::json::parse(certificate_json(test::hand_made_model(), info, certificate));
}

TEST(CertificateJson, SaysAll) {
  const auto json = json_of(hand_made_certificate());
  EXPECT_EQ(json["title"], "a title");
  EXPECT_EQ(json["case"], "case.toml");
  EXPECT_EQ(json["units"], "SI");
  EXPECT_EQ(json["counts"]["bonds"], 2);
  EXPECT_EQ(json["kinematics"], "finite");
  EXPECT_EQ(json["tolerance"], 1e-6);
  EXPECT_EQ(json["agrees"], true);
  EXPECT_EQ(json["static_seconds"], 0.5);
  EXPECT_EQ(json["dynamic_seconds"], 20);
  EXPECT_EQ(json["ratio"], 40);
  EXPECT_EQ(json["warnings"], nlohmann::json::parse(R"(["careful", "slow"])"));
  const auto& one = json["load_cases"][0];
  EXPECT_EQ(one["name"], "push");
  EXPECT_EQ(one["agrees"], true);
  EXPECT_EQ(one["static"]["forward_error"], 1e-15);
  EXPECT_EQ(one["static"]["backward_error"], 1e-17);
  EXPECT_EQ(one["static"]["energy_balance"], 1e-16);
  EXPECT_EQ(one["run"]["end"], "at rest");
}

TEST(CertificateJson, PlacesAreIdsNotPositions) {
  const auto json = json_of(hand_made_certificate());
  const auto& fields = json["load_cases"][0]["differences"];
  EXPECT_EQ(fields[0]["largest_at"], nlohmann::json::parse(R"({"particle": 30})"));
  EXPECT_EQ(fields[1]["largest_at"], nlohmann::json::parse(R"({"bond": 2})"));
  EXPECT_TRUE(fields[2]["largest_at"].is_null());
}

TEST(CertificateJson, OrdersThatWereNotToldApartAreNull) {
  const auto json = json_of(hand_made_certificate());
  const auto& fields = json["load_cases"][0]["differences"];
  EXPECT_EQ(fields[0]["first_order"], 1e-9);
  EXPECT_EQ(fields[0]["second_order"], 0.2);
  EXPECT_TRUE(fields[0]["third_order"].is_null());
  EXPECT_TRUE(fields[1]["second_order"].is_null());
  EXPECT_TRUE(fields[1]["norm"].is_null());
}

TEST(CertificateJson, AgreesOnlyWhereEveryLoadCaseDoes) {
  Certificate certificate = hand_made_certificate();
  certificate.kinematics = Kinematics::small;
  certificate.cases.push_back(certificate.cases.front());
  certificate.cases.back().agrees = false;
  EXPECT_EQ(json_of(certificate)["agrees"], false);
  EXPECT_EQ(json_of(certificate)["kinematics"], "small");
  EXPECT_EQ(json_of(certificate)["load_cases"][1]["agrees"], false);
  certificate.cases.clear();
  EXPECT_EQ(json_of(certificate)["agrees"], false);
}

TEST(CertificateJson, RatioToAnInstantIsNull) {
  Certificate certificate = hand_made_certificate();
  certificate.static_seconds = 0;
  EXPECT_TRUE(json_of(certificate)["ratio"].is_null());
}

}  // namespace
}  // namespace bondstatic
