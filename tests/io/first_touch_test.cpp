#include "io/first_touch.hpp"

#include <gtest/gtest.h>

namespace bondstatic::test {
namespace {

struct Numbers {
  int a = 7;
  double b = -1;
  bool operator==(const Numbers&) const = default;
};

TEST(FirstTouch, MakesTheVectorThatTheConstructorMakes) {
  for (const int threads : {1, 2, 4})
    for (const std::size_t count : {0, 1, 300, 65'536, 65'537, 200'001}) {
      EXPECT_EQ(vector_of<Numbers>(count, threads), std::vector<Numbers>(count));
      EXPECT_EQ(vector_of<double>(count, threads), std::vector<double>(count));
    }
}

TEST(FirstTouch, StaysWithinTheArray) {
  std::vector<char> bytes(std::size_t(3) << 20, 'x');
  const std::size_t begin = 4099, size = (std::size_t(2) << 20) - 1;
  touch_pages(bytes.data() + begin, size, 3);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (i < begin || i >= begin + size) {
      ASSERT_EQ(bytes[i], 'x') << i;
    }
}

}  // namespace
}  // namespace bondstatic::test
