// A model's bonds in the numbers of another code, and the model as that code would realise it.
#pragma once

#include <array>

#include "bond/codes.hpp"

namespace bondstatic {

struct Translation {
  const BondCode* code = nullptr;
  std::vector<std::vector<double>> stored;  ///< [parameter of the code][bond]

  /// The model's bonds; one with coupling is moved to the code's contact point, which changes nothing of it.
  std::vector<BondProperties> wanted;
  std::vector<BondProperties> realised;  ///< what the code makes of the numbers, at its contact point
};

struct TranslatedBond {
  BondProperties wanted;       ///< as in Translation
  std::vector<double> stored;  ///< as BondCode::stored_for gives them
  BondProperties realised;
};
TranslatedBond translate(const BondCode& code, const BondSite& site, BondProperties wanted);

/// Throws what bond_properties throws.
Translation translate(const Model& model, const BondCode& code, int threads = 1);

/// How a block's bonds come through.
struct BlockFit {
  Index bonds = 0;
  /// Of kn, ks, kt, kb: largest |realised - wanted| / wanted; infinite where none is wanted.
  std::array<double, 4> misfit{};
  Index coupled = 0;           ///< bonds whose coupling of shear and bending is lost
  double moved = 0;            ///< largest distance between the contact points, over the bond's length
  Index departing = 0;         ///< bonds whose element in the code is not the one realised here ...
  double departure = 0;        ///< ... and by how much at most
  std::vector<double> lowest;  ///< of each stored number
  std::vector<double> highest;
};
std::vector<BlockFit> block_fits(const Model& model, const Translation& translation);

/// A misfit up to this is rounding.
inline constexpr double exact_fit = 1e-12;

/// Which of the code's conventions a model takes over.
enum class Convention { contact_point, stiffness, both };

/// Bonds, supports and loads keep their order. Bonds with coupling keep it where only the contact point is
/// taken over: moving that changes nothing of them.
Model as_realised(const Model& model, const Translation& translation, Convention convention);

}  // namespace bondstatic
