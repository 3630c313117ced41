#include "results/output_fingerprint.hpp"

#include "io/archive.hpp"

namespace bondstatic {

std::uint64_t fingerprint_of(const std::vector<Output>& outputs) {
  Archive f;
  for (const Output& o : outputs)
    f(o.name, o.of, o.at, o.base, o.axis, o.middle, o.reduce, o.scale, o.load_case);
  return f.checksum();
}

}  // namespace bondstatic
