#include "formats/digest.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace bondstatic::test {
namespace {

std::string text(const Vector3& v) {
  return fmt::format(" {:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

std::string cell_text(const std::optional<Cell>& cell) {
  if (!cell) return "no cell\n";
  EXPECT_GT(cell->edges.determinant(), 0);
  std::string out = "cell" + text(cell->origin);
  for (int i = 0; i < 3; ++i)
    out += text(cell->edges.col(i)) + (cell->periodic[std::size_t(i)] ? " p" : " f");
  return out + "\n";
}

template <class Columns>
std::string column_text(const Columns& columns, std::size_t rows) {
  std::string out;
  for (const auto& [name, values] : columns) {
    EXPECT_EQ(values.size(), rows) << name;
    out += name;
    for (const double value : values) {
      EXPECT_FALSE(std::isinf(value)) << name;
      out += fmt::format(" {:.17g}", value);
    }
    out += "\n";
  }
  return out;
}

std::string vectors_text(const char* name, const std::vector<Vector3>& values, std::size_t rows) {
  if (values.empty()) return "";
  EXPECT_EQ(values.size(), rows) << name;
  std::string out = name;
  for (const Vector3& value : values) {
    EXPECT_TRUE(value.allFinite()) << name;
    out += text(value);
  }
  return out + "\n";
}

}  // namespace

std::string digest(const ForeignModel& model) {
  std::string out =
      model.format + "\n" + cell_text(model.cell) + cell_text(model.box) + (model.si ? "si\n" : "");
  std::set<Index> ids;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    const Particle& p = model.particles[i];
    EXPECT_TRUE(p.id == -1 || (p.id >= 0 && ids.insert(p.id).second)) << p.id;
    EXPECT_TRUE(p.position.allFinite());
    EXPECT_TRUE(std::isnan(p.radius) || (p.radius > 0 && std::isfinite(p.radius))) << p.radius;
    EXPECT_TRUE(std::isnan(p.density) || (p.density > 0 && std::isfinite(p.density))) << p.density;
    out += fmt::format("{}{} {:.17g} {:.17g} group {}\n", p.id, text(p.position), p.radius, p.density,
                       model.group.empty() ? "" : model.group_names.at(std::size_t(model.group.at(i))));
  }
  for (const ForeignBond& bond : model.bonds) {
    EXPECT_NE(bond.a, bond.b);
    EXPECT_TRUE(ids.empty() || (ids.contains(bond.a) && ids.contains(bond.b))) << bond.a << " " << bond.b;
    out += fmt::format("bond {} {} {} {}\n", bond.id, bond.a, bond.b, bond.type);
  }
  EXPECT_TRUE(model.particle_line.empty() || model.particle_line.size() == model.particles.size());
  EXPECT_TRUE(model.bond_line.empty() || model.bond_line.size() == model.bonds.size());
  for (const auto& notes : {model.notes.taken, model.notes.assumed, model.notes.left_out})
    for (const std::string& note : notes) {
      EXPECT_FALSE(note.empty());
      out += note + "\n";
    }
  return out + column_text(model.bond_columns, model.bonds.size()) +
         column_text(model.kept_columns, model.bonds.size());
}

std::string digest(const ParticleState& state) {
  const std::size_t rows = state.id.size();
  EXPECT_EQ(state.position.size(), rows);
  EXPECT_EQ(std::set<Index>(state.id.begin(), state.id.end()).size(), rows);
  EXPECT_TRUE(state.radius.empty() || state.radius.size() == rows);
  EXPECT_TRUE(state.type.empty() || state.type.size() == rows);
  EXPECT_TRUE(state.orientation.empty() || state.orientation.size() == rows);
  std::string out = fmt::format("step {} time {:.17g} {}\n", state.step, state.time, state.unwrapped);
  for (const Index id : state.id) out += fmt::format("{} ", id);
  out += vectors_text("position", state.position, rows) + vectors_text("velocity", state.velocity, rows) +
         vectors_text("angular", state.angular_velocity, rows) + vectors_text("force", state.force, rows) +
         vectors_text("torque", state.torque, rows) + cell_text(state.cell);
  for (const auto& q : state.orientation) {
    EXPECT_NEAR(q.norm(), 1, 1e-12);
    out += fmt::format(" {:.17g} {:.17g} {:.17g} {:.17g}", q.w(), q.x(), q.y(), q.z());
  }
  for (const double radius : state.radius) out += fmt::format(" {:.17g}", radius);
  for (const Index type : state.type) out += fmt::format(" {}", type);
  for (const std::string& note : state.notes) out += "\n" + note;
  return out;
}

std::string digest(const BondState& state) {
  EXPECT_EQ(state.a.size(), state.b.size());
  std::string out = fmt::format("step {}\n", state.step);
  for (std::size_t i = 0; i < state.a.size(); ++i) {
    EXPECT_NE(state.a[i], state.b[i]);
    out += fmt::format("{} {}\n", state.a[i], state.b[i]);
  }
  for (const std::string& note : state.notes) out += note + "\n";
  return out + column_text(state.columns, state.a.size());
}

}  // namespace bondstatic::test
