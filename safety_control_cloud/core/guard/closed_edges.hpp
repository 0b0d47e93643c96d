// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "known.hpp"
#include "switches.hpp"

namespace safety_control_cloud {

/// Which edges of the robot its switches close: each from the first touch until all who speak for it say that it is
/// released, and it was held so.
class ClosedEdges {
 public:
  explicit ClosedEdges(const Switches& switches) : states_(switches.begin(), switches.end()) {}

  /// One who speaks for a switch, a name without spaces, says of an edge whether it is touched there, at `now` [s,
  /// steady]. Whether that is new, or the first word of the switch.
  bool note(std::size_t which, const std::string& who, Edge edge, bool touched, double now);

  /// Who alone could speak for one at `as_of` [s, steady]. What others said until then holds until they are back and
  /// say otherwise, or one does who was not there since the touch, or reset().
  void note_living(std::size_t which, const std::vector<std::string>& who, double as_of);

  /// What was said by who is no more is forgotten: somebody has looked.
  void reset();

  /// Which edges are touched, and by whose word, and who else was there, for another process to go on with; empty if
  /// none is.
  std::string remembered() const;

  /// Goes on with that, as with what was said by who is no more: he may say nothing for as long as it is touched, or
  /// have been released meanwhile. False, and nothing changes, if it is not legible or tells of a switch that is not
  /// there.
  bool recall(const std::string& remembered);

  /// What speaks against a switch that its messages do not tell; none: nothing any more.
  void note_outside(std::size_t which, std::optional<Doubt> doubt) { states_[which].outside = std::move(doubt); }

  /// [s] until the next counts as silent; infinite if none will.
  double until_silent(double now) const;

  /// Of each switch that closes an edge, and of each in doubt, as of a sensor; `release_time` [s] is how long one is
  /// held.
  std::vector<Known> known_at(double now, double release_time) const;

 private:
  struct Word {
    bool touched = false;
    double since = 0.0;             ///< [s, steady]
    std::optional<double> left_at;  ///< when who said it was found to be no more [s, steady]
  };
  struct Said {
    std::map<std::string, Word> by;  ///< name

    bool is_touched() const;
    bool is_left() const;
    bool is_released_since(double moment) const;
  };
  struct State {
    State(const SwitchSettings& of) : settings(of) {}

    SwitchSettings settings;
    std::map<Edge, Said> edges;
    std::map<std::string, double> began_at;  ///< who lives, or did beside a touch: known since [s, steady]
    std::optional<double> spoke_at;          ///< [s, steady]
    std::optional<Doubt> outside;

    bool is_touched() const;
  };

  std::vector<State> states_;
};

}  // namespace safety_control_cloud
