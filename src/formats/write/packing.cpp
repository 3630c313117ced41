#include "formats/write/packing.hpp"

#include <algorithm>
#include <cmath>

#include "io/csv_writer.hpp"
#include "io/number_text.hpp"
#include "io/ordered_blocks.hpp"

namespace bondstatic {
namespace {

constexpr Index block = 1 << 14;  ///< rows formatted at a time

template <class Number>
void append_number(fmt::memory_buffer& text, Number value) {
  char number[longest_number];
  text.append(number, write_number(number, value));
}

bool any_given(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
}

bool any_given(const std::vector<Particle>& particles, double Particle::*member) {
  return std::any_of(particles.begin(), particles.end(),
                     [&](const Particle& particle) { return !std::isnan(particle.*member); });
}

}  // namespace

void write_particle_table(OutputFile& file, const ForeignModel& model) {
  std::vector<double Particle::*> members;
  std::string header = "id,x,y,z";
  for (const auto& [name, member] : {std::pair("radius", &Particle::radius), {"density", &Particle::density}})
    if (any_given(model.particles, member)) {
      header += std::string(",") + name;
      members.push_back(member);
    }
  std::vector<std::string> groups;
  for (const std::string& name : model.group_names) groups.push_back(csv_field(name));
  const bool grouped = !model.group.empty();
  file.append(header + (grouped ? ",group\n" : "\n"));
  write_blocks(file, Index(model.particles.size()), block,
               [&](Index begin, Index end, fmt::memory_buffer& text) {
                 for (Index i = begin; i < end; ++i) {
                   const Particle& particle = model.particles[std::size_t(i)];
                   append_number(text, particle.id);
                   for (const double coordinate : particle.position) {
                     text.push_back(',');
                     append_number(text, coordinate);
                   }
                   for (const auto member : members) {
                     text.push_back(',');
                     append_number(text, particle.*member);
                   }
                   if (grouped) {
                     text.push_back(',');
                     text.append(groups[std::size_t(model.group[std::size_t(i)])]);
                   }
                   text.push_back('\n');
                 }
               });
}

void write_bond_table(OutputFile& file, const ForeignModel& model) {
  std::vector<const std::vector<double>*> columns;
  std::string header = "id,a,b";
  const auto add = [&](const std::string& name, const std::vector<double>& values) {
    if (!any_given(values)) return;
    header += "," + csv_field(name);
    columns.push_back(&values);
  };
  const std::vector<std::string> first{"kn", "ks", "kt", "kb", "contact_point", "radius"};
  for (const std::string& name : first)
    if (const auto found = model.bond_columns.find(name); found != model.bond_columns.end())
      add(name, found->second);
  for (const auto& [name, values] : model.bond_columns)
    if (std::find(first.begin(), first.end(), name) == first.end()) add(name, values);
  for (const auto& [name, values] : model.kept_columns) add(name, values);
  file.append(header + "\n");
  write_blocks(file, Index(model.bonds.size()), block, [&](Index begin, Index end, fmt::memory_buffer& text) {
    for (Index k = begin; k < end; ++k) {
      const ForeignBond& bond = model.bonds[std::size_t(k)];
      append_number(text, bond.id);
      for (const Index end_id : {bond.a, bond.b}) {
        text.push_back(',');
        append_number(text, end_id);
      }
      for (const std::vector<double>* values : columns) {
        text.push_back(',');
        append_number(text, (*values)[std::size_t(k)]);
      }
      text.push_back('\n');
    }
  });
}

}  // namespace bondstatic
