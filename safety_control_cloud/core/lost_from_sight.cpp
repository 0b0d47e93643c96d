// SPDX-License-Identifier: BSD-3-Clause
#include "lost_from_sight.hpp"

namespace safety_control_cloud {
namespace {

constexpr double few_returns = 0.1;  ///< of the points: with more, a camera is not blind for what is before it

/// None too if more is lost than it tells of.
const Loss* loss_in(const Answer& answer) {
  const auto* seen = std::get_if<Seen>(&answer);
  const bool tells = seen && seen->loss && !(seen->loss->covered.empty() && seen->loss->spots.empty());
  return tells ? &*seen->loss : nullptr;
}

bool is_blind(const Answer& answer) {
  const auto* doubt = std::get_if<Doubt>(&answer);
  return doubt && doubt->cause == Cause::Blind;
}

}  // namespace

/// What is in doubt, but for a blind one, says no more of what is lost than silence.
void LostFromSight::note(const Answer& answer, bool is_any_near) {
  const bool is_doubt = std::holds_alternative<Doubt>(answer), blind = is_blind(answer);
  if (!is_doubt || blind) forget_explanation();
  if (blind && is_any_near) has_any_ = true;  // it may be before that
  if (is_doubt) return;
  was_sound_ = true;
  judge(answer);
}

/// As the latest reading that is believed has it.
void LostFromSight::judge(const Answer& answer) {
  const auto& seen = std::get<Seen>(answer);
  has_any_ = seen.loss.has_value();
  is_ahead_ = has_any_ && seen.loss->cause == Cause::NearLoss && !is_explained();
}

void LostFromSight::note_silence(const Answer& answer) {
  if (std::holds_alternative<Doubt>(answer) && !is_blind(answer)) was_sound_ = false;
}

void LostFromSight::note_recalled(bool is_any_lost) {
  spots_ = LostSpots{};
  if (is_any_lost) has_any_ = is_ahead_ = true;
}

bool LostFromSight::note_pose(const Answer& answer, const std::optional<Pose2>& pose, double now) {
  const Loss* lost = loss_in(answer);
  spots_.note(lost ? lost->spots : std::vector<LostSpot>{}, now);
  pose_ = pose;
  return lost != nullptr;
}

void LostFromSight::explain(const Answer& answer, const std::vector<KnownPlace>& known, const LatestLook& look,
                            double blind_range, double time, double now) {
  const Loss* lost = loss_in(answer);
  forget_explanation();
  if (lost && pose_ && is_known(*lost, known, {*pose_, look.outlook, look.field, look.eye, blind_range}, time, now))
    explained_until_ = spots_.kept_until(time, now);
  judge(answer);
}

bool LostFromSight::is_known(const Loss& lost, const std::vector<KnownPlace>& known, const Looking& looking,
                             double time, double now) const {
  return !spots_.have_moved(known, looking) && spots_.are_among(known, looking, time, now) &&
         hides(known, lost.covered, looking.field, looking.blind_range);
}

void LostFromSight::explain_blindness(const Sight& counted, const std::vector<KnownPlace>& known,
                                      const FieldOfView& field, double blind_range, double time, double now) {
  const double returned = static_cast<double>(counted.returns) / static_cast<double>(counted.total);
  forget_explanation();
  if (returned <= few_returns && hides(known, {Span{0.0, 1.0}}, field, blind_range, returned))
    explained_until_ = kept_until(known, field, blind_range, time, now);
}

void LostFromSight::forget_poses() {
  spots_.forget_places();
  pose_.reset();
  forget_explanation();
}

void LostFromSight::forget() {
  spots_ = LostSpots{};
  has_any_ = is_ahead_ = false;
}

bool LostFromSight::is_blind_only(const Answer& answer) const { return was_sound_ && is_blind(answer); }

std::optional<Doubt> LostFromSight::doubt(const Answer& answer, std::size_t min_points) const {
  if (is_blind_only(answer)) return std::get<Doubt>(answer);
  const auto* seen = std::get_if<Seen>(&answer);
  if (!was_sound_ || !seen) return std::nullopt;
  if (seen->loss && !is_explained()) return Doubt{seen->loss->cause, seen->loss->reason};
  if (seen->sight.too_close > 0 && seen->sight.too_close + seen->sight.inside >= min_points)
    return Doubt{Cause::Seen, "something is too close to measure"};
  return std::nullopt;
}

}  // namespace safety_control_cloud
