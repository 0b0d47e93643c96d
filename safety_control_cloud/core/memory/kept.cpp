// SPDX-License-Identifier: BSD-3-Clause
#include "kept.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../text/reader.hpp"

namespace safety_control_cloud {
namespace {

constexpr const char* version = "things-1";
constexpr const char* end = "end";
constexpr std::size_t most_things = 8, most_spots = 12, most_columns = NearGround::most_columns * 2;
constexpr std::size_t most_pixels = 65535;

std::vector<Spot> some_of(const Remembered& thing) {
  std::vector<Spot> all = thing.lost, some;
  all.insert(all.end(), thing.seen.spots.begin(), thing.seen.spots.end());
  const std::size_t step = std::max<std::size_t>(1, (all.size() + most_spots - 1) / most_spots);
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  const double share = size_of(all) / static_cast<double>(some.size());
  for (Spot& spot : some) spot.share = static_cast<float>(share);
  return some;
}

void write(const Remembered& thing, std::ostream& to) {
  const auto spots = some_of(thing);
  to << ' ' << thing.size << ' ' << thing.vanished << ' ' << spots.size();
  for (const Spot& spot : spots) {
    to << ' ' << spot.row << ' ' << spot.column << ' ' << spot.point.x << ' ' << spot.point.y << ' ' << spot.point.z
       << ' ' << spot.share << ' ' << int{spot.company} << ' ' << spot.stands;
  }
}

Spot spot_in(Reader& reader) {
  constexpr double farthest = 100.0;
  Spot spot;
  spot.row = static_cast<std::uint16_t>(reader.count(most_pixels));
  spot.column = static_cast<std::uint16_t>(reader.count(most_pixels));
  spot.point.x = static_cast<float>(reader.number(-farthest, farthest));
  spot.point.y = static_cast<float>(reader.number(-farthest, farthest));
  spot.point.z = static_cast<float>(reader.number(1e-3, farthest));
  spot.share = static_cast<float>(reader.number(0.0, farthest));
  spot.company = static_cast<std::uint8_t>(reader.count(9));
  spot.stands = reader.count(1) == 1;
  return spot;
}

Remembered thing_in(Reader& reader) {
  Remembered thing;
  thing.size = reader.number(0.0, 1e4);
  thing.vanished = reader.count(1) == 1;
  thing.clouds = 1;
  const std::size_t spots = reader.count(most_spots);
  for (std::size_t i = 0; i < spots && reader.good(); ++i) thing.lost.push_back(spot_in(reader));
  return thing;
}

}  // namespace

std::string to_text(const Kept& kept) {
  const bool low = std::any_of(kept.low.begin(), kept.low.end(), [](int floor) { return floor > 0; });
  if (kept.things.empty() && !low && kept.blind_range == 0.0f) return {};
  std::vector<Remembered> things = kept.things;
  std::sort(things.begin(), things.end(), [](const Remembered& a, const Remembered& b) {
    return size_of(a.lost) + a.seen.size > size_of(b.lost) + b.seen.size;
  });
  things.resize(std::min(things.size(), most_things));
  std::ostringstream text;
  text.precision(5);
  text << version << ' ' << kept.width << ' ' << kept.height << ' ' << kept.blind_range << ' ' << things.size();
  for (const Remembered& thing : things) write(thing, text);
  text << ' ' << (low ? kept.low.size() : 0);
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
  const std::size_t things = reader.count(most_things);
  for (std::size_t i = 0; i < things && reader.good(); ++i) kept.things.push_back(thing_in(reader));
  const std::size_t columns = reader.count(most_columns);
  for (std::size_t i = 0; i < columns && reader.good(); ++i) {
    kept.low.push_back(static_cast<NearGround::Code>(reader.number(0.0, 32766.0)));
  }
  if (!reader.good() || reader.word() != end) return std::nullopt;
  return kept;
}

}  // namespace safety_control_cloud
