// SPDX-License-Identifier: BSD-3-Clause
#include "closed_edges.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

#include "../text/reader.hpp"
#include "../text/words.hpp"
#include "drop_from.hpp"

namespace safety_control_cloud {
namespace {

const std::vector<Ring> nothing_seen;
constexpr const char* version = "touched-3";
constexpr const char* end = "end";
constexpr std::size_t most = 10000;                                    ///< words, names
constexpr double some_time = std::numeric_limits<double>::infinity();  ///< [s] nobody knows when

Known said_by(const SwitchSettings& one) {
  Known known;
  known.sensor = one.name;
  known.rings = &nothing_seen;
  return known;
}

std::string in_words(SwitchKind kind, Edge edge) {
  return words(kind == SwitchKind::Cliff ? "the floor ends at the " : "something touches the ", name_of(edge));
}

}  // namespace

bool ClosedEdges::Said::is_touched() const {
  return std::any_of(by.begin(), by.end(), [](const auto& one) { return one.second.touched; });
}

bool ClosedEdges::Said::is_left() const {
  return std::any_of(by.begin(), by.end(), [](const auto& one) { return one.second.left_at.has_value(); });
}

bool ClosedEdges::Said::is_released_since(double moment) const {
  return std::all_of(by.begin(), by.end(),
                     [&](const auto& one) { return !one.second.touched && one.second.since <= moment; });
}

bool ClosedEdges::State::is_touched() const {
  return std::any_of(edges.begin(), edges.end(), [](const auto& one) { return one.second.is_touched(); });
}

bool ClosedEdges::note(std::size_t which, const std::string& who, Edge edge, bool touched, double now) {
  State& state = states_[which];
  const bool is_first = !state.spoke_at;
  state.spoke_at = now;
  const double began_at = state.began_at.try_emplace(who, now).first->second;
  auto& said = state.edges[edge].by;
  const auto is_succeeded = [&](const auto& entry) {
    const auto& [one, word] = entry;
    return word.left_at && (one == who || began_at > *word.left_at);
  };
  const bool succeeds_any = drop_from(said, is_succeeded) > 0;
  const auto own = said.find(who);
  const bool changes = succeeds_any || touched != (own != said.end() && own->second.touched);
  if (changes) said[who] = {touched, now, std::nullopt};
  return is_first || changes;
}

void ClosedEdges::note_living(std::size_t which, const std::vector<std::string>& who, double as_of) {
  State& state = states_[which];
  const auto is_gone = [&](const std::string& one) { return std::find(who.begin(), who.end(), one) == who.end(); };
  for (auto& [edge, said] : state.edges) {
    for (auto& [one, word] : said.by) {
      if (word.touched && word.since <= as_of && is_gone(one))
        word.left_at = std::min(word.left_at.value_or(some_time), as_of);
      else if (word.left_at && !is_gone(one))
        word.left_at = some_time;  // it is back, and has not said anything yet
    }
  }
  if (!state.is_touched())
    drop_from(state.began_at, [&](const auto& entry) { return entry.second <= as_of && is_gone(entry.first); });
  for (const std::string& one : who) {
    double& began_at = state.began_at.try_emplace(one, as_of).first->second;
    began_at = std::min(began_at, as_of);
  }
}

void ClosedEdges::reset() {
  for (State& state : states_) {
    for (auto& [edge, said] : state.edges)
      drop_from(said.by, [](const auto& entry) { return entry.second.left_at.has_value(); });
  }
}

std::string ClosedEdges::remembered() const {
  std::ostringstream touched, known;
  std::size_t touches = 0, names = 0;
  for (const State& state : states_) {
    if (!state.is_touched()) continue;
    for (const auto& [edge, said] : state.edges) {
      for (const auto& [who, word] : said.by) {
        if (!word.touched) continue;
        touched << ' ' << state.settings.name << ' ' << name_of(edge) << ' ' << who;
        ++touches;
      }
    }
    for (const auto& [who, began_at] : state.began_at) {
      known << ' ' << state.settings.name << ' ' << who;
      ++names;
    }
  }
  if (touches == 0) return {};
  return words(version, ' ', touches, touched.str(), ' ', names, known.str(), ' ', end);
}

bool ClosedEdges::recall(const std::string& remembered) {
  Reader reader(remembered);
  if (reader.word() != version) return false;
  auto states = states_;
  const auto state_named = [&](const std::string& name) {
    return std::find_if(states.begin(), states.end(), [&](const State& one) { return one.settings.name == name; });
  };
  const std::size_t touches = reader.count(most);
  for (std::size_t i = 0; i < touches && reader.good(); ++i) {
    const auto state = state_named(reader.word());
    const auto edge = edge_named(reader.word());
    if (state == states.end() || !edge) return false;
    state->edges[*edge].by[reader.word()] = {true, 0.0, some_time};
  }
  const std::size_t names = reader.count(most);
  for (std::size_t i = 0; i < names && reader.good(); ++i) {
    const auto state = state_named(reader.word());
    if (state == states.end()) return false;
    state->began_at[reader.word()] = 0.0;
  }
  if (!reader.good() || reader.word() != end) return false;
  states_ = std::move(states);
  return true;
}

double ClosedEdges::until_silent(double now) const {
  double soonest = std::numeric_limits<double>::infinity();
  for (const State& state : states_) {
    const double left = state.spoke_at ? state.settings.timeout - (now - *state.spoke_at) : 0.0;
    if (left > 0.0) soonest = std::min(soonest, left);
  }
  return soonest;
}

std::vector<Known> ClosedEdges::known_at(double now, double release_time) const {
  std::vector<Known> all;
  for (const State& state : states_) {
    const SwitchSettings& one = state.settings;
    const bool is_silent = one.timeout > 0.0 && !(state.spoke_at && now - *state.spoke_at <= one.timeout);
    if (state.outside || is_silent) {
      all.push_back(said_by(one));
      all.back().doubt = state.outside ? *state.outside : Doubt{Cause::Silent, "no word of it for its timeout"};
    }
    for (const auto& [edge, said] : state.edges) {
      if (said.is_released_since(now - release_time)) continue;
      Known closed = said_by(one);
      closed.is_touched = true;
      closed.eye = Eye{{}, direction_of(edge), 0.0};
      const std::string reason =
          said.is_touched() ? in_words(one.type, edge) : words("it was so until just now: ", in_words(one.type, edge));
      if (said.is_left())
        closed.hint = "its driver says that it is released, or after ~reset, when somebody has looked";
      closed.lost = Doubt{one.type == SwitchKind::Cliff ? Cause::Cliff : Cause::Bumper, reason};
      all.push_back(std::move(closed));
    }
  }
  return all;
}

}  // namespace safety_control_cloud
