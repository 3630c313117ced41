#include "multigrid/link_packs.hpp"

namespace bondstatic::multigrid {

namespace {

/// What K u has at the two ends of each link.
template <class Scalar>
struct Ends {
  Bodies<Scalar> a, b;
};

template <class Scalar, class Stored>
ALWAYS_INLINE Ends<Scalar> forces(const RoundPack<Stored>& pack, int lane, const Bodies<Scalar>& a,
                                  const Bodies<Scalar>& b) {
  using W = Wide<Scalar>;
  const Wide3<Scalar> e = load3<Scalar>(pack.axis, lane);
  const W ta = load<Scalar>(pack.ta + lane), tb = load<Scalar>(pack.tb + lane);
  const W c = load<Scalar>(pack.coupling + lane);
  const Wide3<Scalar> d = b.linear - a.linear - cross(ta * a.angular + tb * b.angular, e);
  const Wide3<Scalar> r = b.angular - a.angular;
  // Axial and transverse parts apart, as they may differ by decades.
  const Wide3<Scalar> along = dot(e, d) * e, twist = dot(e, r) * e;
  const Wide3<Scalar> f =
      load<Scalar>(pack.kn + lane) * along + load<Scalar>(pack.ks + lane) * (d - along) - c * cross(e, r);
  const Wide3<Scalar> m =
      load<Scalar>(pack.kt + lane) * twist + load<Scalar>(pack.kb + lane) * (r - twist) + c * cross(e, d);
  const Wide3<Scalar> lever = cross(e, f), none{};
  return {{none - f, none - m - ta * lever}, {f, m - tb * lever}};
}

template <class Scalar, class Stored>
ALWAYS_INLINE Ends<Scalar> forces(const FullPack<Stored>& pack, int lane, const Bodies<Scalar>& a,
                                  const Bodies<Scalar>& b) {
  using W = Wide<Scalar>;
  const Wide3<Scalar> arm_a = load3<Scalar>(pack.arm_a, lane), arm_b = load3<Scalar>(pack.arm_b, lane);
  const Wide3<Scalar> d = b.linear - a.linear + cross(b.angular, arm_b) - cross(a.angular, arm_a);
  const Wide3<Scalar> r = b.angular - a.angular;
  const W delta[6] = {d.x, d.y, d.z, r.x, r.y, r.z};
  W q[6] = {};
  int entry = 0;
#pragma GCC unroll 6  // or q lies in memory
  for (int i = 0; i < 6; ++i)
#pragma GCC unroll 6
    for (int j = i; j < 6; ++j, ++entry) {
      const W c = load<Scalar>(pack.c[entry] + lane);
      q[i] += c * delta[j];
      if (j > i) q[j] += c * delta[i];
    }
  const Wide3<Scalar> f{q[0], q[1], q[2]}, m{q[3], q[4], q[5]}, none{};
  return {{none - f, none - m - cross(arm_a, f)}, {f, m + cross(arm_b, f)}};
}

// The machine fetches packs ahead of their use by itself, but not beyond the end of a page.
template <class Pack>
ALWAYS_INLINE void fetch_next_page(const Pack& pack) {
  constexpr std::size_t page = 4096, line = 64;
  for (std::size_t at = 0; at < sizeof(Pack); at += line)
    fetch(reinterpret_cast<const char*>(&pack) + page + at);
}

// Rows of other blocks lie anywhere.
template <class Scalar, class Pack>
ALWAYS_INLINE void fetch_other_ends(const std::vector<Pack>& packs, std::size_t k, const Scalar* u) {
  constexpr std::size_t ahead = 4;
  if (k + ahead >= packs.size()) return;
  for (const std::uint32_t b : packs[k + ahead].b) fetch(u + stride * std::size_t(b));
}

template <class Scalar, class Pack>
ALWAYS_INLINE void product(const Block<Pack>& block, const Scalar* u, Scalar* y) {
  for (const Pack& pack : block.inside) {
    fetch_next_page(pack);
    for (int lane = 0; lane < pack_size; lane += lanes<Scalar>) {
      const Ends<Scalar> ends = forces(pack, lane, gather(u, pack.a + lane), gather(u, pack.b + lane));
      scatter_add(ends.a, pack.a + lane, std::size_t(block.first), y);
      scatter_add(ends.b, pack.b + lane, std::size_t(block.first), y);
    }
  }
  for (std::size_t k = 0; k < block.across.size(); ++k) {
    const Pack& pack = block.across[k];
    fetch_next_page(pack);
    fetch_other_ends(block.across, k, u);
    for (int lane = 0; lane < pack_size; lane += lanes<Scalar>) {
      const Ends<Scalar> ends = forces(pack, lane, gather(u, pack.a + lane), gather(u, pack.b + lane));
      scatter_add(ends.a, pack.a + lane, std::size_t(block.first), y);
    }
  }
}

}  // namespace

WIDE_AS_THE_MACHINE void add_product(const Block<RoundPack<float>>& block, const float* u, float* y) {
  product(block, u, y);
}
WIDE_AS_THE_MACHINE void add_product(const Block<RoundPack<float>>& block, const double* u, double* y) {
  product(block, u, y);
}
WIDE_AS_THE_MACHINE void add_product(const Block<RoundPack<double>>& block, const double* u, double* y) {
  product(block, u, y);
}
WIDE_AS_THE_MACHINE void add_product(const Block<FullPack<float>>& block, const float* u, float* y) {
  product(block, u, y);
}
WIDE_AS_THE_MACHINE void add_product(const Block<FullPack<double>>& block, const double* u, double* y) {
  product(block, u, y);
}

}  // namespace bondstatic::multigrid
