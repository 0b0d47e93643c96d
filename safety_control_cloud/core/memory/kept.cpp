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

constexpr const char* version = "things-4";
constexpr const char* end = "end";
constexpr const char* too_much = "things-4 more is lost than can be told";  // which kept_in refuses
constexpr std::size_t most_things = 32, most_spots = 12, most_spots_lost = 8;
constexpr std::size_t most_columns = NearGround::most_columns * 2, most_pixels = 65535;
constexpr double farthest = 100.0;  // [m]

/// What of a spot is kept besides its place: how it goes depends on them.
constexpr std::array<bool Spot::*, 5> flags_kept{&Spot::stands, &Spot::foot_unseen, &Spot::hung_before,
                                                 &Spot::went_alone, &Spot::only_hides};

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
  for (const auto& part : {ahead_of(camera), right_of(camera), place_of(camera)})
    for (const float along : part) to << ' ' << along;
}

/// Those from which any of some spots was seen, each once.
class Cameras {
 public:
  std::size_t number_of(const CameraPose& camera) {
    const auto is_it = [&](const CameraPose& one) { return one.rows == camera.rows || show_the_same(one, camera); };
    const auto known = std::find_if(all_.begin(), all_.end(), is_it);
    const auto number = static_cast<std::size_t>(known - all_.begin());
    if (known == all_.end()) all_.push_back(camera);
    return number;
  }
  const std::vector<CameraPose>& all() const { return all_; }

 private:
  std::vector<CameraPose> all_;
};

void write(const Remembered& thing, Cameras& cameras, std::ostream& to) {
  const auto spots = spots_of(thing);
  to << ' ' << thing.size << ' ' << thing.vanished << ' ' << spots.size();
  for (const Spot& spot : spots) {
    to << ' ' << spot.row << ' ' << spot.column << ' ' << spot.point.x << ' ' << spot.point.y << ' ' << spot.point.z
       << ' ' << spot.share << ' ' << int{spot.company} << ' ' << flags_of(spot) << ' ' << spot.turning << ' '
       << cameras.number_of(spot.camera);
  }
}

CameraPose camera_in(Reader& reader) {
  CameraPose camera;
  const auto read = [&](std::size_t column, double most) {
    for (auto& row : camera.rows) row[column] = static_cast<float>(reader.number(-most, most));
  };
  read(2, 1.001);
  read(0, 1.001);
  read(3, farthest);
  auto& [x, y, z] = camera.rows;
  const auto down = [](const auto& one, const auto& other) { return one[2] * other[0] - other[2] * one[0]; };
  x[1] = down(y, z), y[1] = down(z, x), z[1] = down(x, y);
  return camera;
}

/// Or no spot of it would lie where it does, and some nowhere.
bool is_pose(const CameraPose& camera) {
  constexpr float exact = 0.01f;
  const auto product = [](const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0f);
  };
  const auto ahead = ahead_of(camera), right = right_of(camera);
  return std::abs(product(ahead, ahead) - 1.0f) < exact && std::abs(product(right, right) - 1.0f) < exact &&
         std::abs(product(ahead, right)) < exact;
}

Spot spot_in(Reader& reader, const std::vector<CameraPose>& cameras) {
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
  spot.camera = cameras[reader.count(cameras.size() - 1)];
  return spot;
}

Remembered thing_in(Reader& reader, const std::vector<CameraPose>& cameras) {
  Remembered thing;
  thing.size = reader.number(0.0, 1e4);
  thing.vanished = reader.count(1) == 1;
  thing.clouds = 1;
  const std::size_t spots = reader.count(most_spots);
  for (std::size_t i = 0; i < spots && reader.good(); ++i) thing.lost.push_back(spot_in(reader, cameras));
  return thing;
}

}  // namespace

bool is_any_low(const Kept& kept) {
  return std::any_of(kept.low.begin(), kept.low.end(), [](int floor) { return floor > 0; });
}

std::string to_text(const Kept& kept) {
  const bool low = is_any_low(kept);
  if (kept.things.empty() && !low && kept.blind_range == 0.0f && !kept.more) return {};
  const std::vector<Remembered> things = as_many_of(kept.things);
  if (kept.more || things.size() > most_things) return too_much;
  std::ostringstream text, of_things;
  for (std::ostringstream* one : {&text, &of_things}) one->precision(5);
  Cameras cameras;
  cameras.number_of(kept.camera);  // the first
  for (const Remembered& thing : things) write(thing, cameras, of_things);
  text << version << ' ' << kept.width << ' ' << kept.height << ' ' << kept.blind_range << ' ' << cameras.all().size();
  for (const CameraPose& camera : cameras.all()) write(camera, text);
  text << ' ' << things.size() << of_things.str() << ' ' << (low ? kept.low.size() : 0);
  for (std::size_t i = 0; low && i < kept.low.size(); ++i) text << ' ' << kept.low[i];
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
  const std::size_t poses = reader.count(1 + most_things * most_spots);
  std::vector<CameraPose> cameras;
  for (std::size_t i = 0; i < poses && reader.good(); ++i) cameras.push_back(camera_in(reader));
  if (cameras.empty() || !std::all_of(cameras.begin(), cameras.end(), is_pose)) return std::nullopt;
  kept.camera = cameras.front();
  const std::size_t things = reader.count(most_things);
  for (std::size_t i = 0; i < things && reader.good(); ++i) kept.things.push_back(thing_in(reader, cameras));
  const std::size_t columns = reader.count(most_columns);
  for (std::size_t i = 0; i < columns && reader.good(); ++i) {
    kept.low.push_back(static_cast<NearGround::Code>(reader.number(0.0, 32766.0)));
  }
  if (reader.word() != end || !reader.good()) return std::nullopt;
  return kept;
}

}  // namespace safety_control_cloud
