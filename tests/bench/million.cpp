#include "bench/million.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/packing_case.hpp"
#include "bench/program.hpp"
#include "bench/timing.hpp"

namespace bondstatic::bench {

namespace {

namespace fs = std::filesystem;

constexpr int cores = 2;

double bytes_in(const fs::path& folder) {
  double bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) bytes += double(entry.file_size());
  return bytes;
}

/// What the disk takes at best: so many bytes in one file, written and removed again.
double seconds_to_write(double bytes, const fs::path& path) {
  const std::string piece(std::size_t(1) << 20, '7');
  const double seconds = seconds_of([&] {
    std::ofstream file(path, std::ios::binary);
    for (double left = bytes; left > 0; left -= double(piece.size()))
      file.write(piece.data(), std::streamsize(std::min(left, double(piece.size()))));
    if (!file.flush()) throw std::runtime_error(path.string() + ": cannot write");
  });
  fs::remove(path);
  return seconds;
}

void print_run(const nlohmann::json& summary, const ProgramRun& run) {
  const auto& solver = summary["solver"];
  fmt::print("| particles, bonds, unknowns | {}, {}, {} |\n", summary["counts"]["particles"].get<Index>(),
             summary["counts"]["bonds"].get<Index>(), summary["counts"]["unknowns"].get<Index>());
  fmt::print("| solver | {}, {} of {} threads, {} iterations |\n", solver["name"].get<std::string>(),
             solver["threads"].get<int>(), solver["threads_asked"].get<int>(),
             solver["iterations"].get<Index>());
  double in_phases = 0;
  for (const auto& phase : summary["phases"]) {
    const double seconds = phase["seconds"].get<double>();
    in_phases += seconds;
    fmt::print("| {} | {:.2f} s |\n", phase["name"].get<std::string>(), seconds);
  }
  fmt::print("| the rest: writing, freeing | {:.2f} s |\n", run.seconds - in_phases);
  fmt::print("| **whole process** | **{:.1f} s**, {:.1f} s of processor time |\n", run.seconds,
             run.cpu_seconds);
  fmt::print("| **peak resident memory** | **{:.2f} GB** |\n", 1e-9 * run.peak_bytes);
}

}  // namespace

void print_million(const Million& asked) {
  const fs::path folder = BONDSTATIC_BINARY_DIR "/million";
  write_packing_case(folder, asked.particles);
  const double case_bytes = bytes_in(folder);

  const fs::path results = folder / "results", answer = folder / "answer.json";
  const ProgramRun run =
      run_program({"solve", folder / "case.toml", "--out", results, "--json"}, {answer, cores});
  const auto summary = nlohmann::json::parse(std::ifstream(answer));

  fmt::print("| from case file to written answer on {} cores | figure |\n|---|---|\n", cores);
  print_run(summary, run);
  const double result_bytes = bytes_in(results);
  fmt::print("| case and results on disk | {:.0f} MB and {:.0f} MB |\n", 1e-6 * case_bytes,
             1e-6 * result_bytes);
  fmt::print("| as many bytes as the results, from one buffer | {:.1f} s |\n",
             seconds_to_write(result_bytes, folder / "plain"));
  fmt::print("| relative error at most | {:.1e} (backward error {:.1e}) |\n",
             summary["accuracy"]["forward_error"].get<double>(),
             summary["accuracy"]["backward_error"].get<double>());
  if (asked.keep)
    fmt::print("\ncase, results and summary: {}\n", folder.string());
  else
    fs::remove_all(folder);
}

}  // namespace bondstatic::bench
