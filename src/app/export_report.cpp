#include "app/export_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/report.hpp"
#include "app/terminal.hpp"
#include "bondstatic/version.hpp"

namespace bondstatic {

namespace {

std::string one_a_line(const std::string& heading, const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items)
    text += fmt::format("  {:<10}{}\n", text.empty() ? heading : "", item);
  return text;
}

std::string listed(const std::string& heading, std::vector<std::string> sentences) {
  for (std::string& sentence : sentences) sentence = wrapped(sentence, 12);
  return one_a_line(heading, sentences);
}

}  // namespace

std::string export_report(const ExportAnswer& answer) {
  std::vector<std::string> files;
  for (const std::string& name : answer.notes.files)
    files.push_back((std::filesystem::path(answer.folder) / name).string());
  std::string text = heading(answer.given, facts_of(answer.given.model));
  if (!answer.load_case.empty()) text += "load case " + answer.load_case + '\n';
  text += '\n' + one_a_line("written", files);
  if (!answer.notes.not_expressed.empty()) {
    text += '\n' + red("The exported model is another one:", stdout) + '\n';
    text += listed("differs", answer.notes.not_expressed);
  }
  if (!answer.notes.remarks.empty()) text += '\n' + listed("note", answer.notes.remarks);
  if (!answer.notes.next_steps.empty())
    text += fmt::format("\n  in {}:\n", answer.folder) + one_a_line("next", answer.notes.next_steps);
  return text + warnings_text(answer.given.warnings);
}

std::string export_json(const ExportAnswer& answer) {
  const nlohmann::ordered_json json{
      {"bondstatic", version()},          {"title", answer.given.title},
      {"case", answer.given.file},        {"format", answer.format},
      {"load_case", answer.load_case},    {"relaxed", answer.relaxed},
      {"files", answer.notes.files},      {"not_expressed", answer.notes.not_expressed},
      {"remarks", answer.notes.remarks},  {"next_steps", answer.notes.next_steps},
      {"warnings", answer.given.warnings}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace bondstatic
