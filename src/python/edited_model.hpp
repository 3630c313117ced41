// A model as Python changes it: step by step, each step whole or not at all.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "case/draft.hpp"

namespace bondstatic {

class EditedModel {
 public:
  EditedModel() : draft_(std::make_shared<Draft>()) {}
  explicit EditedModel(Model model);

  const Draft& draft() const { return *draft_; }
  const Model& model() const { return draft_->model; }

  /// The model as it is now, for good: later changes are made to a copy.
  std::shared_ptr<const Model> kept() const { return {draft_, &draft_->model}; }

  /// change(Draft&) reports what is wrong as faults of the reading: the model is then as it was, and
  /// InputError is thrown. Returns the warnings. `caller` stands in messages where files have their name.
  template <class Change>
  std::vector<std::string> edit(const std::string& caller, Change change) {
    const Extent before = begin(caller);
    try {
      change(*draft_);
    } catch (...) {
      undo(before);
      throw;
    }
    return end(before);
  }

  /// The same for what only reads the model, without a copy of what solutions keep.
  template <class Question>
  void ask(const std::string& caller, Question question) {
    draft_->reading.file = caller;
    question(*draft_);
    draft_->reading.warnings.clear();
    if (const auto faults = std::exchange(draft_->reading.faults, {}); !faults.empty())
      throw InputError(faults);
  }

 private:
  struct Extent {
    std::size_t blocks, bonds, supports, loads, strains;
    std::vector<std::string> load_cases, groups;
  };
  Extent begin(const std::string& caller);
  void undo(const Extent& before);
  std::vector<std::string> end(const Extent& before);

  std::shared_ptr<Draft> draft_;
};

}  // namespace bondstatic
