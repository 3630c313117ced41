#include "report/json_value.hpp"

#include <gmock/gmock.h>

#include "bondstatic/error.hpp"
#include "report/found_pages.hpp"

namespace bondstatic::test {

namespace {

using testing::HasSubstr;

JsonValue parsed(const ScratchFolder& folder, const std::string& text) {
  return JsonValue::read(folder.write("a.json", text), "solve again");
}

TEST(JsonOfResults, BrokenTextIsNamedByLineAndColumn) {
  const ScratchFolder folder;
  const std::string said = complaint([&] { parsed(folder, "{\"a\": 1,\n  \"b\": x}"); });
  EXPECT_THAT(said, HasSubstr("a.json:2:8: is no JSON: syntax error"));
  EXPECT_THAT(said, HasSubstr("cure: solve again"));
  EXPECT_THAT(complaint([&] { parsed(folder, ""); }), HasSubstr("a.json:1:1"));
  EXPECT_THAT(complaint([&] { parsed(folder, "[1, 2]"); }), HasSubstr("holds [..] where an object must be"));
  EXPECT_THAT(complaint([&] { parsed(folder, "{\"a\": 1e999}"); }), HasSubstr("number overflow"));
  EXPECT_THAT(complaint([&] { parsed(folder, "{\"a\": \"\xff\"}"); }), HasSubstr("ill-formed UTF-8"));
}

TEST(JsonOfResults, WrongTypesAreNamedByTheirPath) {
  const ScratchFolder folder;
  const JsonValue root = parsed(folder, R"({"a": [{"b": "word"}, 3], "c": true})");
  EXPECT_THAT(complaint([&] { root["a"].items()[0]["b"].number(); }),
              HasSubstr("a.json: a[0].b = \"word\" must be a number"));
  EXPECT_THAT(complaint([&] { root["a"].items()[1]["b"]; }), HasSubstr("a[1] = 3 must be an object"));
  EXPECT_THAT(complaint([&] { root["a"].text(); }), HasSubstr("a = [..] must be a text"));
  EXPECT_THAT(complaint([&] { root["c"].items(); }), HasSubstr("c = true must be a list"));
  EXPECT_THAT(complaint([&] { root["a"].flag(); }), HasSubstr("must be true or false"));
  EXPECT_THAT(complaint([&] { root["a"].items()[0].members().at(0).second.whole(); }),
              HasSubstr("a[0].b = \"word\" must be a whole number"));
}

TEST(JsonOfResults, MissingAndNullAreNotThere) {
  const ScratchFolder folder;
  const JsonValue root = parsed(folder, R"({"a": null})");
  EXPECT_FALSE(root.has("a"));
  EXPECT_FALSE(root["a"].number());
  EXPECT_FALSE(root["b"]["c"]["d"].text());
  EXPECT_TRUE(root["b"].items().empty());
  EXPECT_TRUE(std::isnan(root["b"].number_or_nan()));
}

TEST(JsonOfResults, IdsKeepAllTheirDigits) {
  const ScratchFolder folder;
  const JsonValue root = parsed(folder, R"({"a": 9223372036854775807, "b": 9223372036854775808, "c": 1.5})");
  EXPECT_EQ(*root["a"].whole(), 9223372036854775807);
  EXPECT_THAT(complaint([&] { root["b"].whole(); }), HasSubstr("whole number of 64 bits"));
  EXPECT_THAT(complaint([&] { root["c"].whole(); }), HasSubstr("whole number of 64 bits"));
}

TEST(JsonOfResults, NestingAsDeepAsSomebodyLikesIsSurvived) {
  const ScratchFolder folder;
  const std::string deep = "{\"a\":" + std::string(300'000, '[') + std::string(300'000, ']') + "}";
  EXPECT_THAT(complaint([&] { parsed(folder, deep)["a"].number(); }), HasSubstr("a = [..] must be a number"));
}

}  // namespace

}  // namespace bondstatic::test
