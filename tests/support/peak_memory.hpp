// Peak of the resident size from a moment on.
#pragma once

namespace bondstatic::test {

class PeakMemory {
 public:
  void begin();
  double bytes() const;  ///< above what stood at begin()

 private:
  double stood_ = 0;
};

}  // namespace bondstatic::test
