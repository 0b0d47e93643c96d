// SPDX-License-Identifier: BSD-3-Clause
#include "sensor.hpp"

#include <utility>

#include "aim.hpp"
#include "look/look.hpp"
#include "look/outlook.hpp"
#include "look/passthrough.hpp"
#include "text/reader.hpp"
#include "text/words.hpp"

namespace safety_control_cloud {
namespace {

constexpr const char* in_frame = "in";  // the word before the frame

bool same_corridor(const LookSettings& a, const LookSettings& b) {
  const Corridor one = corridor_of(a), other = corridor_of(b);
  return same_limits(one, other) && one.range_min == other.range_min;
}

Picture picture_of(const View& view, const Sight& sight, const Origin& origin) {
  const auto share_of = [&](std::size_t some) {
    return sight.total == 0 ? 0.0 : static_cast<double>(some) / static_cast<double>(sight.total);
  };
  const auto nearest = sight.nearest ? std::optional<double>(sight.nearest->distance()) : std::nullopt;
  return Picture{origin.stamp, origin.frame, share_of(sight.returns), nearest, share_of(sight.inside),
                 sight.total,  Probes(view)};
}

Returned returned_in(const View& view, const Sight& counted) {
  return {counted.returns, counted.total, height_of(view) > 1};
}

void gather_all(const View& view, const Alongside& alongside) {
  const Runs runs(view);
  Places places;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    gather(runs[i], alongside.outlook, alongside.region, places);
    alongside.take(places);
  }
}

}  // namespace

Sensor::Sensor(const Settings& settings) : settings_(settings), near_loss_(settings.near_loss) {}

void Sensor::adopt(const Settings& settings) {
  judged_.reset();
  if (settings.target_frame != settings_.target_frame) near_loss_.change_axes();
  if (!same_corridor(settings, settings_)) near_loss_.change_corridor();
  near_loss_.limit(settings.near_loss);
  settings_ = settings;
}

void Sensor::turn_corridor(const Settings& settings, double angle) {
  near_loss_.turn_corridor(angle);
  settings_ = settings;
}

void Sensor::forget_losses() {
  judged_.reset();
  recalled_ = false;
  near_loss_.forget();
  stamps_.forget();
  blind_.forget();
}

std::string Sensor::remembered() const {
  const std::string& text = near_loss_.serialised();
  const std::string& frame = settings_.target_frame;
  return text.empty() || frame.empty() ? text : words(in_frame, ' ', frame, ' ', text);
}

bool Sensor::recall(const std::string& remembered) {
  if (remembered.empty()) return true;
  Reader reader(remembered);
  const bool is_placed = reader.word() == in_frame;
  const std::string frame = is_placed ? reader.word() : "";
  if (!near_loss_.restore(is_placed ? reader.rest() : remembered)) return false;
  judged_.reset();
  if (frame != settings_.target_frame) near_loss_.change_axes();
  recalled_ = near_loss_.is_any_near();
  return true;
}

void Sensor::see(const Reading& reading, const Origin& origin, const Instant& now, Crop crop,
                 const Alongside* alongside) {
  last_arrival_ = now.steady;
  counted_ = Sight{};
  repeats_ = false;
  answer_ = answer_to(reading, origin, now, crop, alongside);
}

void Sensor::wait(const Instant& now) {
  std::optional<Doubt> doubt = clock_.note(now.ros);
  if (doubt) stamps_.forget();
  const double silence = last_arrival_ ? now.steady - *last_arrival_ : 0.0;
  if (!doubt && silence > settings_.source_timeout) {
    doubt = Doubt{Cause::Silent, "no cloud for " + measured(silence, "s")};
  }
  if (!doubt) return;
  counted_ = Sight{};
  answer_ = *std::move(doubt);
}

Answer Sensor::answer_to(const Reading& reading, const Origin& origin, const Instant& now, Crop crop,
                         const Alongside* alongside) {
  auto jump = clock_.note(now.ros);
  if (jump) stamps_.forget();
  if (auto doubt = sources_.note(origin.source, now.steady, settings_.source_timeout)) return *std::move(doubt);
  if (jump) return *std::move(jump);
  if (const auto* unreadable = std::get_if<Unreadable>(&reading)) return Doubt{Cause::Unreadable, unreadable->reason};
  if (auto doubt = stamps_.note(now.ros - origin.stamp, now.steady, settings_)) return *std::move(doubt);
  const auto outlook = outlook_of(settings_, origin.placing);
  if (const auto* missing = std::get_if<NoTransform>(&outlook)) return Doubt{Cause::NoTransform, missing->reason};
  return look_at(reading, std::get<Outlook>(outlook), origin, now.steady, crop, alongside);
}

Answer Sensor::look_at(const Reading& reading, const Outlook& outlook, const Origin& origin, double now, Crop crop,
                       const Alongside* alongside) {
  const View view = view_in(reading, settings_);
  const Rows rows = near_loss_.rows_for(view);
  if (settings_.method == Method::Pcl) {
    counted_ = passthrough(view, outlook, crop, rows);
    if (alongside) gather_all(view, *alongside);
  } else {
    counted_ = look_alongside(view, outlook, crop, rows, alongside);
  }
  const auto [upright, in_upright] = upright_.of(view, outlook);
  upright_view_ = upright;
  if (auto doubt = turns_.note(picture_of(view, counted_, origin), now, settings_.source_timeout))
    return *std::move(doubt);
  auto blind = blind_.note(returned_in(view, counted_), settings_, now);
  const auto* scan = std::get_if<ScanView>(&reading);
  auto aim =
      scan ? doubt_about_plane(*scan, outlook, settings_.limits) : doubt_about_aim(view, outlook, settings_.limits);
  const Sight turned = upright_.is_turned() ? look(upright, in_upright, Crop::Skip, rows) : Sight{};
  const Sight& sight = upright_.is_turned() ? turned : counted_;
  if (blind && !aim) near_loss_.note_blind(upright, sight, in_upright, now);
  if (blind || aim) return blind ? *std::move(blind) : *std::move(aim);
  auto frozen = frozen_.note(view, origin.stamp, settings_.frozen_clouds);
  repeats_ = frozen_.repeats();
  if (frozen) return *std::move(frozen);
  if (!repeats_ || !judged_) judge(upright, sight, in_upright, origin.stamp, now);
  return Seen{counted_, judged_->loss, judged_->is_cut_off};
}

void Sensor::judge(const View& view, const Sight& sight, const Outlook& outlook, double stamp, double now) {
  const double since = gap_.note(stamp, now, settings_.source_timeout);
  auto loss = near_loss_.judge(view, sight, outlook, now, since);
  const bool is_cut_off = near_loss_.cuts_off(sight, outlook);
  recalled_ = recalled_ && loss;
  if (recalled_) loss->reason += ", as before this start";
  judged_ = Judged{std::move(loss), is_cut_off};
}

}  // namespace safety_control_cloud
