// Work in a forked child: its peak memory is its own, and nothing it does to threads or heap is felt by what
// is measured next.
#pragma once

#include <functional>

namespace bondstatic::bench {

enum class ChildEnd { done, died, out_of_time };

/// `work` writes into the buffer it is given, `size` bytes, zero at first.
ChildEnd in_child(double seconds, const std::function<void(void*)>& work, void* buffer, int size);

}  // namespace bondstatic::bench
