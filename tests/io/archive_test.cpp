#include "io/archive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "bondstatic/error.hpp"

namespace bondstatic {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const ArchiveFormat format{"checkpoint", 3};

enum class Kind : std::uint16_t { soft = 7, hard = 65535 };

struct Inner {
  std::string name;
  std::vector<double> values;
};

void describe(Archive& archive, Inner& inner) {
  archive(inner.name, inner.values);
}

struct Everything {
  double real = 0;
  float small = 0;
  Index index = 0;
  std::int8_t byte = 0;
  bool flag = false, other = true;
  Kind kind = Kind::soft;
  std::string text;
  std::vector<double> reals;
  std::vector<Index> indices;
  std::vector<Kind> kinds;
  std::vector<bool> flags;
  std::vector<Vector6> vectors;
  Matrix3 matrix = Matrix3::Zero();
  std::array<double, 3> numbers{};
  std::array<bool, 2> switches{};
  std::vector<std::array<std::int32_t, 2>> pairs;
  std::vector<std::string> names;
  std::vector<std::vector<Vector3>> nested;
  std::vector<Inner> inner;
};

void describe(Archive& archive, Everything& all) {
  archive(all.real, all.small, all.index, all.byte, all.flag, all.other, all.kind, all.text, all.reals,
          all.indices, all.kinds, all.flags, all.vectors, all.matrix, all.numbers, all.switches, all.pairs,
          all.names, all.nested, all.inner);
}

double nan_with(std::uint64_t payload) {
  return std::bit_cast<double>(0xfff0000000000000u | payload);
}

std::vector<double> peculiar() {
  using Limits = std::numeric_limits<double>;
  // A signalling NaN is one whose upper payload bit is clear.
  return {-0.0,
          0.0,
          Limits::denorm_min(),
          -Limits::min() / 3,
          Limits::infinity(),
          Limits::max(),
          nan_with(0xabc),
          nan_with(0x8000000000001),
          std::nextafter(1.0, 2.0)};
}

Everything filled() {
  Everything all;
  const std::vector<double> odd = peculiar();
  all.real = nan_with(42);
  all.small = -std::numeric_limits<float>::denorm_min();
  all.index = std::numeric_limits<Index>::min();
  all.byte = -128;
  all.flag = true;
  all.other = false;
  all.kind = Kind::hard;
  all.text = std::string("a\0b\xff", 4);
  all.reals = odd;
  all.indices = {-1, 0, Index(1) << 62};
  all.kinds = {Kind::soft, Kind::hard};
  all.flags = {true, false, true, true};
  for (int i = 0; i < 3; ++i) all.vectors.push_back(Vector6::Map(&odd[i]));
  all.matrix = Matrix3::Map(odd.data());
  all.numbers = {odd[0], odd[6], odd[2]};
  all.switches = {true, false};
  all.pairs = {{1, -2}, {3, -4}};
  all.names = {"", "x", std::string(100, 'y')};
  all.nested = {{}, {Vector3(1, -0.0, 3)}, {}};
  all.inner = {{"one", odd}, {"", {}}};
  return all;
}

template <class T>
std::string written(const T& data) {
  Archive archive(format);
  archive(data);
  return archive.finish();
}

template <class T>
T read(std::string_view file) {
  T data;
  Archive archive(format, file, "run.state");
  archive(data);
  archive.expect_end();
  return data;
}

template <class T>
std::string refusal(std::string_view file) {
  try {
    read<T>(file);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr("\n    cure: "));
    return error.what();
  }
  return "";
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(Archive, BringsBackEveryBit) {
  const Everything before = filled();
  const Everything after = read<Everything>(written(before));
  EXPECT_EQ(std::bit_cast<std::uint64_t>(after.real), std::bit_cast<std::uint64_t>(before.real));
  EXPECT_EQ(std::bit_cast<std::uint32_t>(after.small), std::bit_cast<std::uint32_t>(before.small));
  EXPECT_EQ(after.index, before.index);
  EXPECT_EQ(after.byte, before.byte);
  EXPECT_TRUE(after.flag);
  EXPECT_FALSE(after.other);
  EXPECT_EQ(after.kind, before.kind);
  EXPECT_EQ(after.text, before.text);
  EXPECT_TRUE(same_bits(after.reals, before.reals));
  EXPECT_EQ(after.indices, before.indices);
  EXPECT_EQ(after.kinds, before.kinds);
  EXPECT_EQ(after.flags, before.flags);
  EXPECT_TRUE(same_bits(after.vectors, before.vectors));
  EXPECT_EQ(std::memcmp(after.matrix.data(), before.matrix.data(), sizeof before.matrix), 0);
  EXPECT_EQ(std::memcmp(&after.numbers, &before.numbers, sizeof before.numbers), 0);
  EXPECT_EQ(after.switches, before.switches);
  EXPECT_EQ(after.pairs, before.pairs);
  EXPECT_EQ(after.names, before.names);
  EXPECT_EQ(after.nested, before.nested);
  ASSERT_EQ(after.inner.size(), 2u);
  EXPECT_EQ(after.inner[0].name, "one");
  EXPECT_TRUE(same_bits(after.inner[0].values, before.inner[0].values));
  EXPECT_EQ(written(after), written(before));
}

TEST(Archive, BringsBackEmptyOnesIntoFilledOnes) {
  const std::string file = written(Everything());
  Everything data = filled();
  Archive(format, file, "run.state")(data);
  EXPECT_EQ(written(data), file);
}

TEST(Archive, RefusesEveryFlippedByte) {
  const std::string sound = written(filled());
  ASSERT_EQ(refusal<Everything>(sound), "");
  for (std::size_t i = 0; i < sound.size(); ++i)
    for (const int change : {1, 0x80, 0xff}) {
      std::string file = sound;
      file[i] = char(file[i] ^ change);
      EXPECT_THAT(refusal<Everything>(file), StartsWith("run.state: ")) << i;
    }
}

TEST(Archive, RefusesEveryTruncationAndExtension) {
  const std::string sound = written(filled());
  for (std::size_t size = 0; size < sound.size(); ++size)
    EXPECT_THAT(refusal<Everything>(std::string_view(sound).substr(0, size)), StartsWith("run.state: is "));
  EXPECT_THAT(refusal<Everything>(sound + '\0'), HasSubstr("is damaged: it should hold"));
}

TEST(Archive, SaysWhatIsWrong) {
  EXPECT_THAT(refusal<int>("title = \"case\""), StartsWith("run.state: is no checkpoint of this program\n"));
  Archive older({"checkpoint", 2});
  EXPECT_THAT(refusal<int>(older.finish()),
              StartsWith("run.state: was written by version 2 of the checkpoint format; this program reads "
                         "version 3\n"));
  std::string file = written(7);
  file.back() ^= 1;
  EXPECT_THAT(refusal<int>(file), StartsWith("run.state: is damaged: its checksum"));
}

TEST(Archive, RefusesToReadOtherThanWhatWasWritten) {
  EXPECT_THAT(refusal<double>(written(float(1))), HasSubstr("ends before all is read"));
  EXPECT_THAT(refusal<float>(written(1.0)), HasSubstr("4 bytes are left over"));
  for (const std::uint64_t length : {std::uint64_t(2), std::uint64_t(1) << 61, ~std::uint64_t(0)}) {
    EXPECT_THAT(refusal<std::vector<double>>(written(std::array{length, std::uint64_t(1)})),
                HasSubstr(std::to_string(length) + " is more than it holds"));
    EXPECT_NE(refusal<std::vector<Inner>>(written(std::array{length, std::uint64_t(1)})), "");
    EXPECT_NE(refusal<std::string>(written(std::array{length << 8, std::uint64_t(1)})), "");
  }
}

TEST(Archive, DoesNotReadIntoConstants) {
  const std::string file = written(7);
  const int constant = 8;
  Archive archive(format, file, "run.state");
  EXPECT_THROW(archive(constant), std::logic_error);
}

TEST(Fingerprint, TellsDataApart) {
  std::map<std::uint64_t, int> seen;
  ++seen[fingerprint(filled())];
  ++seen[fingerprint()];
  ++seen[fingerprint(0.0)];
  ++seen[fingerprint(-0.0)];
  ++seen[fingerprint(0.0, 0.0)];
  ++seen[fingerprint(std::string("ab"), std::string("c"))];
  ++seen[fingerprint(std::string("a"), std::string("bc"))];
  for (std::size_t size = 1; size <= 100; ++size) ++seen[fingerprint(std::vector<char>(size))];
  EXPECT_EQ(seen.size(), 107u);
  EXPECT_EQ(fingerprint(filled()), fingerprint(filled()));
}

}  // namespace
}  // namespace bondstatic
