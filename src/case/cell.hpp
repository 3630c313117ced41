// [cell]: the periodic cell.
//
//   size     = [LX, LY, LZ]                       edges along the axes, or
//   edges    = [[AX, AY, AZ], [B..], [C..]]       any three independent vectors
//   origin   = [0, 0, 0]                          the corner that the edges start from
//   periodic = ["x", "y", "z"]                    the first, second, third edge: along which the model goes
//   on
//
// Without any [[loads]], a cell that is periodic in all directions gets one load case a unit strain ("xx",
// "yy", "zz", "yz", "xz", "xy"), whose stresses are the effective stiffness. Without any [[supports]], a cell
// that is periodic in two directions or more has the translation of one particle held, which no strain can
// tell.
#pragma once

#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

void read_cell(Draft& draft, Node* table);

/// What a cell is given where the case leaves it open; after bonds, supports and loads have been read.
void complete_cell(Draft& draft, bool has_loads, bool has_supports);

/// A strain = { xx = 1e-3, yz = .. } of a [[loads]] block: components of the tensor.
std::optional<Matrix3> read_strain(Draft& draft, TableReader& block);

}  // namespace bondstatic
