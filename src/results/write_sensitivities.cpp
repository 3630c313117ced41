#include <algorithm>

#include "io/csv_writer.hpp"
#include "results/columns.hpp"
#include "results/sensitivities.hpp"

namespace bondstatic {

namespace {

void write_table(OutputFile& file, const Model& model, const std::vector<OutputValue>& outputs) {
  std::string text = "output,block,law,parameter,value,derivative,elasticity\n";
  for (const OutputValue& output : outputs)
    for (const ParameterSensitivity& of : output.sensitivities)
      text += csv_field(output.name) + ',' + std::to_string(of.block) + ',' +
              model.blocks[std::size_t(of.block)].law + ',' + of.parameter + ',' + csv_number(of.value) +
              ',' + csv_number(of.derivative) + ',' + csv_number(of.elasticity) + '\n';
  file.append(text);
}

/// A column for each output and parameter, whatever block the bond is of.
void write_bond_table(OutputFile& file, const Model& model, const std::vector<OutputValue>& outputs) {
  std::vector<Column> columns = bond_ends(model);
  for (const OutputValue& output : outputs) {
    std::vector<std::pair<std::string, std::vector<double>>> by_parameter;
    for (const ParameterSensitivity& of : output.sensitivities) {
      const auto same = [&](const auto& known) { return known.first == of.parameter; };
      const auto known = std::find_if(by_parameter.begin(), by_parameter.end(), same);
      if (known == by_parameter.end()) {
        by_parameter.emplace_back(of.parameter, of.of_bond);
        continue;
      }
      for (std::size_t k = 0; k < of.of_bond.size(); ++k)
        if (!std::isnan(of.of_bond[k])) known->second[k] = of.of_bond[k];
    }
    for (auto& [parameter, numbers] : by_parameter)
      columns.emplace_back(output.name + " per " + parameter, std::move(numbers));
  }
  write_csv(file, columns);
}

}  // namespace

std::vector<std::string> sensitivity_files(const std::vector<OutputValue>& outputs) {
  std::vector<std::string> files;
  const auto any = [&](auto has) {
    return std::any_of(outputs.begin(), outputs.end(), [&](const OutputValue& output) {
      return std::any_of(output.sensitivities.begin(), output.sensitivities.end(), has);
    });
  };
  if (any([](const ParameterSensitivity&) { return true; })) files.push_back(sensitivity_table);
  if (any([](const ParameterSensitivity& s) { return !s.of_bond.empty(); }))
    files.push_back(bond_sensitivity_table);
  return files;
}

void write_sensitivities(FileSet& files, const Model& model, const std::vector<OutputValue>& outputs) {
  for (const std::string& name : sensitivity_files(outputs)) {
    OutputFile& file = files.create(name);
    if (name == sensitivity_table)
      write_table(file, model, outputs);
    else
      write_bond_table(file, model, outputs);
  }
}

}  // namespace bondstatic
