// Long output formatted in blocks, several at a time, and written in order.
#pragma once

#include <fmt/format.h>

#include <functional>

#include "bondstatic/types.hpp"
#include "io/output_file.hpp"

namespace bondstatic {

/// Appends what stands for items [begin, end) to `text`; called by several threads at once.
using FormatItems = std::function<void(Index begin, Index end, fmt::memory_buffer& text)>;

/// Writes items 0 ... count-1 in blocks of `block` on file.threads() threads; what is written does not depend
/// on their number. Rethrows what the file throws.
void write_blocks(OutputFile& file, Index count, Index block, const FormatItems& format);

}  // namespace bondstatic
