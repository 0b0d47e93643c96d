// SPDX-License-Identifier: BSD-3-Clause
#include "kept.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <sstream>

#include "../text/reader.hpp"

namespace safety_control_cloud {
namespace {

constexpr const char* version = "things-3";
constexpr const char* end = "end";
constexpr const char* too_much = "things-3 more is lost than can be told";  // which kept_in refuses
constexpr std::size_t most_things = 32, most_spots = 12, most_spots_lost = 8;
constexpr std::size_t most_columns = NearGround::most_columns * 2, most_pixels = 65535;
constexpr double farthest = 100.0;  // [m]

/// What of a spot is kept besides its place: how it goes depends on them.
constexpr std::array<bool Spot::*, 4> flags_kept{&Spot::stands, &Spot::foot_unseen, &Spot::hung_before,
                                                 &Spot::went_alone};

/// So many at most, evenly; they stand for all.
std::vector<Spot> some_of(const std::vector<Spot>& all, std::size_t most) {
  std::vector<Spot> some;
  if (all.empty()) return some;
  const std::size_t step = std::max<std::size_t>(1, (all.size() + most - 1) / most);
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  const double share = size_of(all) / static_cast<double>(some.size());
  for (Spot& spot : some) spot.share = static_cast<float>(share);
  return some;
}

/// What is lost of a large thing may be little of it.
std::vector<Spot> spots_of(const Remembered& thing) {
  auto spots = some_of(thing.lost, thing.is_seen() ? most_spots_lost : most_spots);
  const auto seen = some_of(thing.seen.spots, most_spots - spots.size());
  spots.insert(spots.end(), seen.begin(), seen.end());
  return spots;
}

const CameraPose& camera_of(const std::vector<Spot>& lost, const std::vector<Spot>& seen) {
  return (lost.empty() ? seen : lost).front().camera;
}

std::vector<Spot> taken_from(const CameraPose& camera, std::vector<Spot>& spots) {
  const auto other = std::stable_partition(spots.begin(), spots.end(), [&](const Spot& spot) {
    return spot.camera == camera || show_the_same(spot.camera, camera);
  });
  std::vector<Spot> some(spots.begin(), other);
  spots.erase(spots.begin(), other);
  return some;
}

std::vector<Remembered> parted_by_camera(std::vector<Remembered> things) {
  std::vector<Remembered> parts;
  for (Remembered& thing : things) {
    const double size = thing.size;
    bool is_whole = true;
    while (!thing.lost.empty() || thing.is_seen()) {
      const CameraPose camera = camera_of(thing.lost, thing.seen.spots);
      Remembered part = thing;
      part.lost = taken_from(camera, thing.lost);
      part.seen.spots = taken_from(camera, thing.seen.spots);
      is_whole = is_whole && thing.lost.empty() && !thing.is_seen();
      if (!is_whole) part.size = std::min(size, size_of(part.lost) + size_of(part.seen.spots));
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

bool is_any_lost(const Remembered& thing) { return !thing.lost.empty(); }

/// All that are lost, and of those that are only seen, and will be seen again, the nearest.
std::vector<Remembered> as_many_of(std::vector<Remembered> things) {
  const auto seen = std::partition(things.begin(), things.end(), is_any_lost);
  const auto nearer = [](const Remembered& a, const Remembered& b) { return a.seen.nearest < b.seen.nearest; };
  std::sort(seen, things.end(), nearer);
  const auto lost = static_cast<std::size_t>(seen - things.begin());
  things.resize(std::min(things.size(), std::max(lost, most_things)));
  return things;
}

/// In one number.
unsigned flags_of(const Spot& spot) {
  unsigned flags = 0;
  for (std::size_t i = 0; i < flags_kept.size(); ++i) flags |= spot.*flags_kept[i] ? 1U << i : 0U;
  return flags;
}

void set_flags(Spot& spot, std::size_t flags) {
  for (std::size_t i = 0; i < flags_kept.size(); ++i) spot.*flags_kept[i] = (flags >> i & 1U) != 0;
}

void write(const CameraPose& camera, std::ostream& to) {
  for (const auto& part : {camera.ahead, camera.right, camera.at})
    for (const float along : part) to << ' ' << along;
}

void write(const Remembered& thing, std::ostream& to) {
  const auto spots = spots_of(thing);
  to << ' ' << thing.size << ' ' << thing.vanished << ' ' << spots.size();
  for (const Spot& spot : spots) {
    to << ' ' << spot.row << ' ' << spot.column << ' ' << spot.point.x << ' ' << spot.point.y << ' ' << spot.point.z
       << ' ' << spot.share << ' ' << int{spot.company} << ' ' << flags_of(spot) << ' ' << spot.turning;
  }
  write(camera_of(spots, spots), to);
}

CameraPose camera_in(Reader& reader) {
  CameraPose camera;
  for (auto* direction : {&camera.ahead, &camera.right})
    for (float& along : *direction) along = static_cast<float>(reader.number(-1.001, 1.001));
  for (float& along : camera.at) along = static_cast<float>(reader.number(-farthest, farthest));
  return camera;
}

/// Or no spot of it would lie where it does, and some nowhere.
bool is_pose(const CameraPose& camera) {
  constexpr float exact = 0.01f;
  const auto product = [](const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0f);
  };
  return std::abs(product(camera.ahead, camera.ahead) - 1.0f) < exact &&
         std::abs(product(camera.right, camera.right) - 1.0f) < exact &&
         std::abs(product(camera.ahead, camera.right)) < exact;
}

bool makes_sense(const Remembered& thing) { return !thing.lost.empty() && is_pose(thing.lost.front().camera); }

Spot spot_in(Reader& reader) {
  Spot spot;
  spot.row = static_cast<std::uint16_t>(reader.count(most_pixels));
  spot.column = static_cast<std::uint16_t>(reader.count(most_pixels));
  spot.point.x = static_cast<float>(reader.number(-farthest, farthest));
  spot.point.y = static_cast<float>(reader.number(-farthest, farthest));
  spot.point.z = static_cast<float>(reader.number(1e-3, farthest));
  spot.share = static_cast<float>(reader.number(0.0, farthest));
  spot.company = static_cast<std::uint8_t>(reader.count(9));
  set_flags(spot, reader.count((1U << flags_kept.size()) - 1));
  spot.turning = static_cast<float>(reader.number(0.0, 10.0));
  return spot;
}

Remembered thing_in(Reader& reader) {
  Remembered thing;
  thing.size = reader.number(0.0, 1e4);
  thing.vanished = reader.count(1) == 1;
  thing.clouds = 1;
  const std::size_t spots = reader.count(most_spots);
  for (std::size_t i = 0; i < spots && reader.good(); ++i) thing.lost.push_back(spot_in(reader));
  const CameraPose camera = camera_in(reader);
  for (Spot& spot : thing.lost) spot.camera = camera;
  return thing;
}

}  // namespace

bool is_any_low(const Kept& kept) {
  return std::any_of(kept.low.begin(), kept.low.end(), [](int floor) { return floor > 0; });
}

std::string to_text(const Kept& kept) {
  const bool low = is_any_low(kept);
  if (kept.things.empty() && !low && kept.blind_range == 0.0f && !kept.more) return {};
  const std::vector<Remembered> things = as_many_of(parted_by_camera(kept.things));
  if (kept.more || things.size() > most_things) return too_much;
  std::ostringstream text;
  text.precision(5);
  text << version << ' ' << kept.width << ' ' << kept.height << ' ' << kept.blind_range << ' ' << things.size();
  for (const Remembered& thing : things) write(thing, text);
  text << ' ' << (low ? kept.low.size() : 0);
  for (std::size_t i = 0; low && i < kept.low.size(); ++i) text << ' ' << kept.low[i];
  if (low) text << ' ' << kept.camera_height;
  text << ' ' << end;
  return text.str();
}

std::optional<Kept> kept_in(const std::string& text) {
  Reader reader(text);
  if (reader.word() != version) return std::nullopt;
  Kept kept;
  kept.width = reader.count(most_pixels);
  kept.height = reader.count(most_pixels);
  kept.blind_range = static_cast<float>(reader.number(0.0, 10.0));
  const std::size_t things = reader.count(most_things);
  for (std::size_t i = 0; i < things && reader.good(); ++i) kept.things.push_back(thing_in(reader));
  const std::size_t columns = reader.count(most_columns);
  for (std::size_t i = 0; i < columns && reader.good(); ++i) {
    kept.low.push_back(static_cast<NearGround::Code>(reader.number(0.0, 32766.0)));
  }
  if (columns > 0) kept.camera_height = static_cast<float>(reader.number(-farthest, farthest));
  if (reader.word() != end || !reader.good()) return std::nullopt;
  if (!std::all_of(kept.things.begin(), kept.things.end(), makes_sense)) return std::nullopt;
  return kept;
}

}  // namespace safety_control_cloud
