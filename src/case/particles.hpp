// [[particles]]: one generator or file a block.
//
//   line    = { from = [..], to = [..], count = N }  or { from, step, count }; both ends are particles
//   arc     = { centre, radius, axis = "z", start = [..], turns = 1 | angle = "90 deg", count }
//   helix   = the same and pitch, the advance along the axis for a full turn; positive angles turn
//   right-handed.
//             `start` is the direction of the first particle from the centre. One closed turn does not repeat
//             its first particle.
//   lattice = { kind = "simple-cubic" | "bcc" | "fcc", count = [NX, NY, NZ] conventional cells, spacing =
//   lattice
//             constant a of the conventional cell, origin }
//   file    = "packing.csv" with columns x, y, z, radius | diameter and, where wanted, id, density, group; or
//   a
//             file of another code: LAMMPS data (with atom_style where it does not say it) or dump (step: its
//             last unless given), YADE, EDEM, MUSEN, PFC. Their types are groups, "type 1"
//
//   radius, density, group = "name" | [names]; jitter (part of the radius) | jitter_length: largest change of
//   each coordinate; removal (part of the particles); seed. Ids without a file's id column go on from the
//   largest so far, from 1.
#pragma once

#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

void read_particles(Draft& draft, Node* list);

}  // namespace bondstatic
