// Generated networks for the tests of mechanisms: random packings, sound models, and defects to plant in
// them.
#pragma once

#include <cmath>
#include <cstdlib>

#include "mechanism/mechanism_models.hpp"

namespace bondstatic::test {

using Random = std::mt19937_64;

/// Ten times as many models where BONDSTATIC_FULL=1.
inline bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

inline double uniform(Random& random, double low = 0, double high = 1) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
inline Index pick(Random& random, Index count) {
  return std::uniform_int_distribution<Index>(0, count - 1)(random);
}
inline Vector3 direction(Random& random) {
  std::normal_distribution<double> normal;
  return Vector3(normal(random), normal(random), normal(random)).normalized();
}

/// Random places in a box that holds `density` of them per unit volume; pairs closer than 1.2 are neighbours.
inline Net random_packing(Random& random, Index count, double density) {
  Net net;
  const double side = std::cbrt(double(count) / density);
  for (int tries = 0; net.count() < count && tries < 10000; ++tries) {
    const Vector3 place(uniform(random, 0, side), uniform(random, 0, side), uniform(random, 0, side));
    bool clear = true;
    for (Index p = 0; p < net.count(); ++p) clear = clear && (net.at(p) - place).norm() > 0.6;
    if (clear) net.particle(place, 0.3);
  }
  return net;
}

template <class Law>
void bond_neighbours(Net& net, double reach, Law law) {
  for (Index a = 0; a < net.count(); ++a)
    for (Index b = a + 1; b < net.count(); ++b)
      if ((net.at(b) - net.at(a)).norm() < reach) law(a, b);
}

/// A random packing of at most `most` particles with laws of every kind of deficiency, any share of the
/// bonds, and supports of every kind of dof.
inline Net random_network(Random& random, Index most) {
  Net net = random_packing(random, 1 + pick(random, most), uniform(random, 0.6, 2.2));
  const double reach = uniform(random, 0.9, 1.7), deficient = uniform(random), friction = uniform(random);
  bond_neighbours(net, reach, [&](Index a, Index b) {
    SectionStiffness law = beam;
    if (uniform(random) < deficient) {
      law = uniform(random) < friction ? contact : frictionless;
      if (uniform(random) < 0.2)
        law = {double(pick(random, 2)), double(pick(random, 2)), double(pick(random, 2)),
               double(pick(random, 2)), 0};
    }
    net.bond(a, b, law, uniform(random) < 0.5 ? 0.5 : uniform(random));
  });
  for (Index p = 0; p < net.count(); ++p) {
    if (uniform(random) < 0.12) net.hold(p);
    if (uniform(random) < 0.1) net.free[std::size_t(p)] &= std::uint8_t(pick(random, 64));
  }
  return net;
}

/// A sound model: a lattice or a disordered packing of beams, among them some contact bonds where the rest
/// holds anyway, stiffnesses over eight decades, any unit of length, turned and away from the origin.
struct Sound {
  Net net;
  double spacing = 1;
  Matrix3 turn;
  Vector3 origin;

  Vector3 place(const Vector3& local) const { return origin + spacing * (turn * local); }
};

inline SectionStiffness scattered(Random& random, SectionStiffness law) {
  for (double* k : {&law.kn, &law.ks, &law.kt, &law.kb}) *k *= std::pow(10, uniform(random, -4, 4));
  return law;
}

inline Sound sound_model(Random& random) {
  Sound sound;
  sound.spacing = std::pow(10, uniform(random, -6, 3));
  sound.turn = Eigen::AngleAxisd(uniform(random, 0, 3), direction(random)).toRotationMatrix();
  sound.origin = sound.spacing * uniform(random, 0, 20) * direction(random);
  Net& net = sound.net;
  const Index side = 2 + pick(random, 4);
  const double jitter = pick(random, 2) ? 0.15 : 0;
  for (Index k = 0; k < side; ++k)
    for (Index j = 0; j < side; ++j)
      for (Index i = 0; i < side; ++i)
        net.particle(sound.place(Vector3(double(i), double(j), double(k)) + jitter * direction(random)),
                     0.5 * sound.spacing);
  // Beams join each particle to an earlier one; of the bonds beyond this tree some have no moments.
  const Index rows[3] = {1, side, side * side};
  for (Index p = 1; p < net.count(); ++p) {
    bool joined = false;
    for (int axis = 0; axis < 3; ++axis) {
      if (p / rows[axis] % side == 0) continue;
      const bool hinge = joined && pick(random, 3) == 0;
      net.bond(p - rows[axis], p, scattered(random, hinge ? contact : beam));
      joined = true;
    }
  }
  return sound;
}

inline void hold_well(Random& random, Net& net) {
  if (pick(random, 2)) return net.hold(pick(random, net.count()));
  // Three corners of the lattice's bottom, far from a line.
  const Index side = Index(std::lround(std::cbrt(double(net.count()))));
  for (const Index p : {Index(0), side - 1, side * (side - 1)}) net.hold(p, "xyz");
}

enum Defect {
  lone,
  pair,
  on_one_contact,
  on_two_contacts,
  body_on_line,
  missing_support,
  frictionless_cup,
  defects
};

/// Plants the defect and returns one particle of it.
inline Index plant(Random& random, Sound& sound, Defect defect) {
  Net& net = sound.net;
  const Index count = net.count(), root = pick(random, count);
  const double s = sound.spacing;
  if (defect != missing_support) hold_well(random, net);
  const Vector3 outside = net.at(root) + 1.1 * s * direction(random);
  switch (defect) {
    case lone:
      return net.particle(outside, 0.4 * s);
    case pair: {
      const Index a = net.particle(outside, 0.4 * s),
                  b = net.particle(outside + s * direction(random), 0.4 * s);
      net.bond(a, b, scattered(random, beam));
      return b;
    }
    case on_one_contact: {
      const Index p = net.particle(outside, 0.4 * s);
      net.bond(p, root, scattered(random, contact), uniform(random));
      return p;
    }
    case on_two_contacts: {
      const Index other = (root + 1) % count, p = net.particle((net.at(root) + net.at(other)) / 2, 0.1 * s);
      net.bond(root, p, scattered(random, contact));
      net.bond(p, other, scattered(random, contact));
      return p;
    }
    case body_on_line: {
      // Three particles stand over three of a lattice row, each on one contact bond.
      Net& n = net;
      const Vector3 x = direction(random), up = x.unitOrthogonal();
      Index below = root, last = -1;
      for (int i = 0; i < 3; ++i) {
        if (i > 0) {
          const Index next = n.particle(net.at(below) + s * x, 0.5 * s);
          n.bond(below, next, scattered(random, beam));
          below = next;
        }
        const Index over = n.particle(net.at(below) + s * up, 0.5 * s);
        n.bond(below, over, scattered(random, contact));
        if (last >= 0) n.bond(last, over, scattered(random, beam));
        last = over;
      }
      return last;
    }
    case missing_support: {
      const char* const lacking[] = {"yzuvw", "xzuvw", "xyuvw", "xyzvw", "xyzuw", "xyzuv", "xyz", "uvw", "z"};
      net.hold(root, lacking[pick(random, 9)]);
      return root;
    }
    case frictionless_cup: {
      const Index p = net.particle(outside, 0.4 * s);
      for (int i = 0; i < 5; ++i) net.bond(pick(random, count), p, scattered(random, frictionless));
      return p;
    }
    case defects:
      break;
  }
  return -1;
}

}  // namespace bondstatic::test
