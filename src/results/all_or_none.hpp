// A part of the work that all ranks do, or none has done.
#pragma once

#include <functional>

#include "system/ranks.hpp"

namespace bondstatic {

/// Calls `part`, in which no rank may wait for another, and waits for all ranks. Where it throws on some of
/// them, it throws on all: there what was thrown, elsewhere an Error with the code and the words of the
/// lowest rank that failed.
void all_or_none(Ranks& ranks, const std::function<void()>& part);

}  // namespace bondstatic
