#include "results/ranked_outputs.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "io/message.hpp"
#include "results/apparent_poisson.hpp"
#include "results/apparent_young.hpp"
#include "results/inquiry.hpp"

namespace bondstatic {

namespace {

bool is_of_specimen(MadeOf made) {
  return made == MadeOf::apparent_young || made == MadeOf::apparent_poisson;
}

std::vector<Index> places_of(const Output& output, MadeOf made) {
  std::vector<Index> places = output.at;
  if (is_of_specimen(made)) places.insert(places.end(), output.base.begin(), output.base.end());
  if (made == MadeOf::apparent_poisson)
    places.insert(places.end(), output.middle.begin(), output.middle.end());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

Question question_of(const Output& output, MadeOf made_of, std::size_t load_case,
                     const std::vector<Index>& places) {
  Question question{false, made_of, output.of, output.axis, load_case, {}};
  for (const Index place : places)
    if (!question.places.empty() && question.places.back()[1] == place)
      ++question.places.back()[1];
    else
      question.places.push_back({place, place + 1});
  return question;
}

/// What the ranks answer, by place, taken out in any order.
template <class Value>
class Gathered {
 public:
  explicit Gathered(const std::vector<Index>& places) : places_(places) {}

  void put(const std::vector<Index>& places, const std::vector<Value>& values) {
    values_.resize(places_.size());
    for (std::size_t i = 0; i < places.size(); ++i) values_[number(places[i])] = values[i];
    found_ += places.size();
  }
  std::vector<Value> at(const std::vector<Index>& places) const {
    if (found_ != places_.size()) throw std::logic_error("no rank, or several, own what an output asks for");
    std::vector<Value> values;
    values.reserve(places.size());
    for (const Index place : places) values.push_back(values_[number(place)]);
    return values;
  }

 private:
  std::size_t number(Index place) const {
    return std::size_t(std::lower_bound(places_.begin(), places_.end(), place) - places_.begin());
  }

  const std::vector<Index>& places_;  // ascending
  std::vector<Value> values_;
  std::size_t found_ = 0;
};

/// At rank 0.
OutputValue ask(const Output& output, const Piece& piece, const StaticSolution& solution, Ranks& ranks) {
  std::vector<const State*> states;
  for (const State& state : solution.cases) states.push_back(&state);
  const MadeOf made = made_of(output);
  if (made == MadeOf::effective) return told(output, effective_value(output, solution.effective));
  const State& state = load_case_of(output, states);
  if (made == MadeOf::energy) return told(output, state.energy);
  if (made == MadeOf::work) return told(output, state.work);
  if (made == MadeOf::stress) return told(output, stress_value(output, state));

  const auto load_case = std::size_t(std::find(states.begin(), states.end(), &state) - states.begin());
  const std::vector<Index> places = places_of(output, made);
  const Question question = question_of(output, made, load_case, places);
  ranks.broadcast(packed(question));
  Gathered<double> values(places);
  Gathered<SpecimenParticle> specimen(places);
  LateralBox box;
  for (const std::string& bytes : ranks.gather(packed(reply_to(question, piece, solution)))) {
    const Reply one = unpacked<Reply>(bytes);
    if (is_of_specimen(made))
      specimen.put(one.places, one.specimen);
    else
      values.put(one.places, one.values);
    box.include(one.box);
  }
  if (made == MadeOf::apparent_young)
    return told(output, apparent_young(output, specimen.at(output.base), specimen.at(output.at), box));
  if (made == MadeOf::apparent_poisson)
    return told(output, apparent_poisson(output, specimen.at(output.base), specimen.at(output.at),
                                         specimen.at(output.middle)));
  return told(output, reduce(output, values.at(output.at)));
}

}  // namespace

std::vector<OutputValue> evaluate_outputs_on_ranks(const std::vector<Output>& outputs, const Piece& piece,
                                                   const StaticSolution& solution, Ranks& ranks) {
  if (ranks.rank() > 0) {
    for (;;) {
      const Question question = unpacked<Question>(ranks.broadcast(""));
      if (question.last) return {};
      ranks.gather(packed(reply_to(question, piece, solution)));
    }
  }
  const auto dismiss = [&] { ranks.broadcast(packed(Question{true, {}, "", Vector3::Zero(), 0, {}})); };
  std::vector<OutputValue> values;
  try {
    for (const Output& output : outputs) values.push_back(ask(output, piece, solution, ranks));
  } catch (const Error&) {  // of the output, so no exchange is going on
    dismiss();
    throw;
  }
  dismiss();
  return values;
}

}  // namespace bondstatic
