// box = { min, max } of a selector: the one place where numbers may be infinite.
#pragma once

#include <functional>
#include <optional>

#include "bondstatic/model.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// Whether a centre lies in the box, boundary included; nothing where the box is at fault.
std::optional<std::function<bool(const Particle&)>> box_test(TableReader reader);

}  // namespace bondstatic
