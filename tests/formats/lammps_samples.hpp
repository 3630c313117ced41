// Small files of LAMMPS and LIGGGHTS for the tests of their readers.
#pragma once

#include <string>

namespace bondstatic::test {

/// Atom style bpm/sphere, as write_data writes it: periodic along x and y (image flags), bonds through both.
inline const std::string bpm_data =
    R"(LAMMPS data file via write_data, version 29 Aug 2024, timestep = 700, units = si

3 atoms
2 atom types
2 bonds
2 bond types

0 4 xlo xhi
0 5 ylo yhi
-1 6 zlo zhi

Bond Coeffs # bpm/rotational

1 1e6 4e5 0.05 0.08 10 20 30 40 0.3 0.4 3e-8 4e-8
2 2e6 5e5 0.06 0.09 11 21 31 41 0.5 0.6 5e-8 6e-8

Atoms # bpm/sphere

2 1 2 1.1 2500 3.75 1.5 2 0 0 0
1 1 1 1 2650 0.5 1.25 2.0625 1 0 0
7 1 1 0.9 2650 3.5 0.5 2 0 -1 0

Velocities

1 0 0 0.001 0 0 0
2 0 0 0.001 0 0 0
7 0 0 0.001 0 0 0

Bonds

1 2 1 2
2 1 2 7
)";

/// Two steps of style custom, the box tilted.
inline const std::string custom_dump = R"(ITEM: UNITS
si
ITEM: TIME
0
ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS xy xz yz pp pp ff
-1 6.5 0.5
0 5 -1
0 6 0
ITEM: ATOMS id type radius density x y z ix iy iz vx vy vz
1 1 0.5 2650 1 2 3 0 0 0 0 0 0
2 2 0.6 2500 2 2 3 0 0 0 0 0 0
ITEM: TIME
0.01
ITEM: TIMESTEP
1000
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS xy xz yz pp pp ff
-1 6.5 0.5
0 5 -1
0 6 0
ITEM: ATOMS id type radius density x y z ix iy iz vx vy vz
2 2 0.6 2500 2.25 2 3 0 1 0 0.1 0.2 0.3
1 1 0.5 2650 1.125 2 3 -1 0 0 0 0 1e-3
)";

inline const std::string local_dump = R"(ITEM: TIMESTEP
1000
ITEM: NUMBER OF ENTRIES
3
ITEM: BOX BOUNDS ff ff ff
0 1
0 1
0 1
ITEM: ENTRIES index c_bl[1] c_bl[2] c_bl[3] c_bf[1]
1 1 2 1 0.5
2 2 3 1 0.25
3 1 3 2 -1e-3
)";

}  // namespace bondstatic::test
