// Faults in the files that a case names, and in settings of the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;

struct BadFile {
  std::string name;
  std::string content;
  int line;
  int column;
  std::string message;
};

void PrintTo(const BadFile& bad, std::ostream* out) {
  *out << bad.name;
}

std::string name_of(const testing::TestParamInfo<BadFile>& test) {
  return test.param.name;
}

void expect_one_fault(const std::vector<Fault>& faults, const std::string& file, const BadFile& bad) {
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "read without a fault" : InputError(faults).what());
  EXPECT_EQ(faults[0].place.file, file);
  EXPECT_EQ(faults[0].place.line, bad.line);
  EXPECT_EQ(faults[0].place.column, bad.column);
  EXPECT_THAT(faults[0].message, HasSubstr(bad.message));
  EXPECT_FALSE(faults[0].cure.empty());
}

class BadPacking : public testing::TestWithParam<BadFile> {};

TEST_P(BadPacking, IsOneFaultWithPlaceAndCure) {
  const std::string text = sound_case({{2, "file = \"packing.csv\""}, {3, ""}});
  expect_one_fault(faults_of(text, {}, {{"packing.csv", GetParam().content}}), "packing.csv", GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Packings, BadPacking,
    testing::Values(
        BadFile{"Empty", "", 1, 1, "no rows"}, BadFile{"HeaderOnly", "x,y,z,radius\n", 1, 1, "no rows"},
        BadFile{"CommentsOnly", "# a\n\n# b\n", 3, 1, "no rows"},
        BadFile{"NoHeader", "0,0,0,1\n1,0,0,1\n", 1, 1, "the number 0 where a column name must be"},
        BadFile{"ColumnTwice", "x,y,z,X,radius\n0,0,0,0,1\n", 1, 7, "column \"X\" is there twice"},
        BadFile{"ColumnByTwoNames", "x,y,z,radius,r\n0,0,0,1,1\n", 1, 14, "mean the same"},
        BadFile{"RadiusAndDiameter", "x,y,z,radius,d\n0,0,0,1,1\n", 1, 14, "exclude each other"},
        BadFile{"NoZ", "x,y,radius\n0,0,1\n", 1, 1, "no column z; found: x, y, radius"},
        BadFile{"RowShort", "x,y,z,radius\n0,0,0,1\n0,0,1\n", 3, 1, "the row has 3 fields, the header 4"},
        BadFile{"RowLong", "x,y,z,radius\n0,0,0,1,\n", 2, 1, "the row has 5 fields"},
        BadFile{"NotANumber", "x,y,z,radius\n0,0,zero,1\n", 2, 5, "z = \"zero\" is not a number"},
        BadFile{"DecimalComma", "x;y;z;radius\n0;0,5;0;1\n", 2, 3, "y = \"0,5\" is not a number"},
        BadFile{"FieldEmpty", "x,y,z,radius\n0,,0,1\n", 2, 3, "y is empty"},
        BadFile{"NotFinite", "x,y,z,radius\n0,0,inf,1\n", 2, 5, "not a finite double"},
        BadFile{"TooLarge", "x,y,z,radius\n0,0,1e999,1\n", 2, 5, "not a finite double"},
        BadFile{"Nan", "x,y,z,radius\n0,0,nan,1\n", 2, 5, "is not a number"},
        BadFile{"RadiusZero", "x,y,z,radius\n0,0,0,0\n", 2, 7, "radius = 0 must be positive"},
        BadFile{"DiameterNegative", "x,y,z,D\n0,0,0,-2\n", 2, 7, "D = -2 must be positive"},
        BadFile{"DensityZero", "x,y,z,r,rho\n0,0,0,1,0\n", 2, 9, "rho = 0 must be positive"},
        BadFile{"IdBroken", "id,x,y,z,r\n1.5,0,0,0,1\n", 2, 1, "id = 1.5 must be a whole number"},
        BadFile{"IdNegative", "id,x,y,z,r\n-1,0,0,0,1\n", 2, 1, "id = -1 must be a whole number"},
        BadFile{"IdTwice", "x,y,z,id,r\n0,0,0,7,1\n1,0,0,7,1\n", 3, 7, "particle id 7 is there twice"},
        BadFile{"QuoteOpen", "x,y,z,radius\n0,\"0,0,1\n", 2, 3, "a quote opens here"},
        BadFile{"TextAfterQuote", "x,y,z,radius\n0,\"0\"0,0,1\n", 2, 3, "a quote opens here"}),
    name_of);

TEST(PackingFile, BinaryIsAFaultOfTheCase) {
  const std::string text = sound_case({{2, "file = \"packing.csv\""}, {3, ""}});
  const auto faults = faults_of(text, {}, {{"packing.csv", std::string("x,y\0z", 5)}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.line, 2);
  EXPECT_THAT(faults[0].message, HasSubstr("is binary"));
}

TEST(PackingFile, RadiusInBothPlacesIsAFault) {
  const auto faults =
      faults_of(sound_case({{2, "file = \"packing.csv\""}}), {}, {{"packing.csv", "x,y,z,r\n0,0,0,1\n"}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.line, 3);
  EXPECT_THAT(faults[0].message, HasSubstr("here and in the file"));
}

TEST(PackingFile, ManyFaultsOfOneKindEndAfterTwenty) {
  std::string content = "x,y,z,radius\n";
  for (int i = 0; i < 1000; ++i) content += "a,0,0,1\n";
  const auto faults =
      faults_of(sound_case({{2, "file = \"packing.csv\""}, {3, ""}}), {}, {{"packing.csv", content}});
  ASSERT_EQ(faults.size(), 21u);
  EXPECT_THAT(faults.back().message, HasSubstr("more such faults"));
}

class BadBondFile : public testing::TestWithParam<BadFile> {};

TEST_P(BadBondFile, IsOneFaultWithPlaceAndCure) {
  const std::string text = sound_case({{7, "poisson = 0.3\nfile = \"bonds.csv\""}});
  expect_one_fault(faults_of(text, {}, {{"bonds.csv", GetParam().content}}), "bonds.csv", GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Bonds, BadBondFile,
    testing::Values(
        BadFile{"NoB", "a,c\n1,2\n", 1, 1, "no column b; found: a, c"},
        BadFile{"UnknownParticle", "a,b\n1,2\n2,30\n", 3, 3, "there is no particle 30"},
        BadFile{"ToItself", "a,b\n1,1\n", 2, 1, "joins a particle to itself"},
        BadFile{"PairTwice", "a,b\n1,2\n2,1\n", 3, 1, "particles 2 and 1 are bonded already"},
        BadFile{"IdTwice", "id,a,b\n4,1,2\n4,2,3\n", 3, 1, "bond id 4 is there twice"},
        BadFile{"Misspelt", "a,b,yuong\n1,2,1e9\n", 1, 5,
                "column \"yuong\" is no parameter of law timoshenko"},
        BadFile{"GivenStiffness", "a,b,kn\n1,2,1e9\n", 1, 5, "column \"kn\" is no parameter"},
        BadFile{"OutOfBounds", "a,b,young\n1,2,1e9\n2,3,-1\n", 3, 5, "young = -1: must be positive"},
        BadFile{"ParameterText", "a,b,young\n1,2,stiff\n", 2, 5, "young = \"stiff\" is not a number"}),
    name_of);

struct BadSetting {
  std::string name;
  std::string setting;
  std::string message;
};

void PrintTo(const BadSetting& bad, std::ostream* out) {
  *out << bad.name;
}

class BadOverride : public testing::TestWithParam<BadSetting> {};

TEST_P(BadOverride, IsOneFaultThatNamesTheSetting) {
  const auto faults = faults_of(sound_case(), {GetParam().setting});
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "read without a fault" : InputError(faults).what());
  EXPECT_EQ(faults[0].place.file, "--set " + GetParam().setting);
  EXPECT_EQ(faults[0].place.line, 0);
  EXPECT_THAT(faults[0].message, HasSubstr(GetParam().message));
  EXPECT_FALSE(faults[0].cure.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Settings, BadOverride,
    testing::Values(BadSetting{"NoValue", "bonds.0.young", "KEY=VALUE"},
                    BadSetting{"EmptyValue", "bonds.0.young=", "KEY=VALUE"},
                    BadSetting{"NoKey", "=3", "KEY=VALUE"},
                    BadSetting{"EmptyPart", "bonds..young=3", "empty part"},
                    BadSetting{"OutOfRange", "bonds.1.young=3", "\"1\" is no position in bonds, which has 1"},
                    BadSetting{"NotAPosition", "bonds.first.young=3", "\"first\" is no position in bonds"},
                    BadSetting{"ThroughNumber", "particles.0.radius.x=3",
                               "particles.0.radius = 0.2 has no parts"},
                    BadSetting{"TooLong", "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a=1", "too many parts"},
                    BadSetting{"UnknownKey", "bonds.0.yuong=3", "unknown key \"yuong\""},
                    BadSetting{"UnknownBlock", "bond.young=3", "unknown key \"bond\""},
                    BadSetting{"BadValue", "bonds.0.young=-5", "young = -5: must be positive"},
                    BadSetting{"BadUnit", "bonds.0.young=200 Gpa", "unknown unit \"Gpa\""},
                    BadSetting{"WrongType", "particles.0.line=3", "line = 3 must be a table"}),
    [](const auto& test) { return test.param.name; });

TEST(BadCaseFile, MissingFolderAndBinaryAreFaults) {
  const ScratchFolder folder;
  for (const std::string& file : {(folder / "none.toml").string(), folder.path().string(), std::string(),
                                  folder.write("binary.toml", std::string("a\0b", 3))}) {
    try {
      read_case(file);
      ADD_FAILURE() << file << " was read";
    } catch (const InputError& error) {
      ASSERT_EQ(error.faults().size(), 1u);
      EXPECT_EQ(error.faults()[0].place.file, file);
      EXPECT_FALSE(error.faults()[0].cure.empty());
    }
  }
}

TEST(BadCaseFile, EmptyHasNoParticles) {
  const auto faults = faults_of("");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0].message, HasSubstr("no [[particles]]"));
}

TEST(BadCaseFile, AllFaultsAreSaidAtOnceInTheOrderOfTheFile) {
  const std::string text = sound_case({{3, "radius = -1"},
                                       {6, "young = -1"},
                                       {10, "at = { id = 99, grup = 1 }"},
                                       {14, "force = 3"},
                                       {17, "of = \"uw\""}});
  const auto faults = faults_of(text, {"solve.threads=-2"});
  std::vector<int> lines;
  for (const Fault& fault : faults) lines.push_back(fault.place.line);
  // Ids cannot be judged where the particles are at fault: no 99 here. The setting has no line and comes
  // last.
  EXPECT_EQ(lines, (std::vector<int>{3, 6, 10, 14, 17, 0})) << InputError(faults).what();
}

TEST(BadCaseFile, AFaultOfParticlesOrBondsIsNotRepeatedByWhatRefersToThem) {
  const std::string bond_output = "[[outputs]]\nname = \"s\"\nof = \"sigma\"\nat = { bond = 3 }";
  EXPECT_EQ(faults_of(sound_case({{3, "radius = -1"}, {19, bond_output}})).size(), 1u);
  EXPECT_EQ(faults_of(sound_case({{5, "law = \"glue\""}, {19, bond_output}})).size(), 1u);
}

TEST(BadCaseFile, GarbageNeverCrashes) {
  // Prefixes and single-byte changes of a sound case: each reads or is an InputError.
  const std::string text = sound_case();
  int bad = 0;
  for (std::size_t at = 0; at < text.size(); at += 3)
    for (const char c : {'\0', '[', '"', '=', '\n', '9', '\xff'}) {
      std::string spoilt = c == '\0' ? text.substr(0, at) : text;
      if (c != '\0') spoilt[at] = c;
      bad += !faults_of(spoilt).empty();
    }
  EXPECT_GT(bad, 100);
}

}  // namespace
}  // namespace bondstatic::test
