// The memory that the analysis predicts against the peak of the solve, in a process of its own.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "bondstatic/error.hpp"
#include "bondstatic/statics.hpp"
#include "support/models.hpp"
#include "support/peak_memory.hpp"

namespace bondstatic::test {
namespace {

struct Bytes {
  double predicted, peak;
};

void measure(const Model& model, Bytes& bytes) {
  PeakMemory peak;
  StaticOptions options;
  options.solver = "cholmod";
  options.threads = 1;
  options.progress = [&](const std::string& phase) {
    if (phase == "analysis") peak.begin();
  };
  bytes.predicted = solve_statics(model, options).report.analysis.predicted_bytes;
  bytes.peak = peak.bytes();
}

Model packing(int edge) {
  std::mt19937_64 random(3);
  Model model = random_packing(random, edge, block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}}));
  if (model.supports.empty()) fix_all(model, 0);
  load(model, Index(model.particles.size()) - 1, vector6(1, 2, 3));
  return model;
}

// Promised from 20,000 unknowns up; there, what does not grow with the model weighs most.
TEST(MemoryPrediction, IsWithin15PercentOfThePeak) {
  const Model model = packing(15);
  void* shared = mmap(nullptr, sizeof(Bytes), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  Bytes& bytes = *new (shared) Bytes{0, 0};
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    measure(model, bytes);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
  EXPECT_GT(bytes.peak, 5e7);
  EXPECT_LT(bytes.predicted, 1.15 * bytes.peak);
  EXPECT_GT(bytes.predicted, 0.85 * bytes.peak);
  munmap(shared, sizeof(Bytes));
}

TEST(MemoryPrediction, RefusesInTheAnalysisWhatDoesNotFit) {
  const Model model = packing(8);
  StaticOptions options;
  options.memory_limit = 1e5;
  std::vector<std::string> phases;
  options.progress = [&](const std::string& phase) { phases.push_back(phase); };
  EXPECT_THROW(solve_statics(model, options), MemoryError);
  ASSERT_FALSE(phases.empty());
  EXPECT_EQ(phases.back(), "analysis");
}

}  // namespace
}  // namespace bondstatic::test
