// What damage does to a reader: it must answer a sound result or faults that a user can act on, never both,
// never neither, and never crash.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic::test {

/// Reads a file and writes down all that it found (digest.hpp), so that two readings can be compared; checks
/// on its way that the result is sound. Faults that have no better place are to be put at `named_at`.
using DigestingReader =
    std::function<std::optional<std::string>(const std::string& path, std::vector<Fault>& faults)>;

/// Where the case that names a file would do so; pass it to the reader under test.
inline const Place named_at{"case.toml", 3, 8};

struct Damage {
  std::string name;
  std::string text;
};

/// Cut at the end of every line, and at bytes in between.
std::vector<Damage> truncations(const std::string& text);

/// Fields replaced by nan, inf, 1e400, 2^63, -1, words, nothing; lines swapped, doubled and left out; NUL
/// bytes, garbage, a line of 10 MB.
std::vector<Damage> damages(const std::string& text);

/// Result and faults of one reading, after checking that there is exactly one of them, and that each fault
/// has a file, a line, a message and a cure.
struct Answer {
  std::optional<std::string> digest;
  std::vector<Fault> faults;
};
Answer read_damaged(const DigestingReader& reader, const std::string& text,
                    const std::string& name = "damaged");

/// No result, and among the faults one whose message or cure has `mention`, in `line` where that is not 0.
void expect_fault(const DigestingReader& reader, const std::string& text, const std::string& mention,
                  int line = 0);

/// `text` is sound: it reads the same with CRLF and a byte order mark, and truncations and damages are borne.
void expect_robust(const DigestingReader& reader, const std::string& text);

}  // namespace bondstatic::test
