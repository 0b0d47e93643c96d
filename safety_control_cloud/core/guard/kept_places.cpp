// SPDX-License-Identifier: BSD-3-Clause
#include "kept_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "../text/reader.hpp"

namespace safety_control_cloud {
namespace {

constexpr const char* version = "places-1";
constexpr const char* end = "end";
constexpr double close_by = 0.04, layer = 0.1;  ///< [m] across and up
constexpr std::size_t most = 2000;              ///< places
constexpr double farthest = 1e5;                ///< [m] farther than anybody drives in memory_time
constexpr double millimetre = 1e-3;             ///< [m]
constexpr double almost_half = 0.499e-3;        ///< [m] so that it is rounded up

std::vector<KeptPlace> some_of(const std::vector<KeptPlace>& all) {
  std::map<std::array<long, 3>, KeptPlace> some;
  for (const KeptPlace& one : all) {
    const std::array<long, 3> cell = {std::lround(one.place.x / close_by), std::lround(one.place.y / close_by),
                                      std::lround(one.height / layer)};
    const Point2 middle{close_by * static_cast<double>(cell[0]), close_by * static_cast<double>(cell[1])};
    const double off = one.off + length_of(one.place - middle);
    KeptPlace& kept = some.emplace(cell, KeptPlace{middle, one.height, off}).first->second;
    kept.off = std::max(kept.off, off);
  }
  std::vector<KeptPlace> places;
  for (const auto& [cell, place] : some) places.push_back(place);
  const auto nearer = [](const KeptPlace& a, const KeptPlace& b) { return length_of(a.place) < length_of(b.place); };
  std::sort(places.begin(), places.end(), nearer);
  places.resize(std::min(places.size(), most));
  return places;
}

long in_millimetres(double value) { return std::lround(value / millimetre); }

KeptPlace place_in(Reader& reader) {
  const auto metres = [&](double least) {
    return millimetre * reader.number(least / millimetre, farthest / millimetre);
  };
  KeptPlace place{};
  place.place.x = metres(-farthest);
  place.place.y = metres(-farthest);
  place.height = metres(-farthest);
  place.off = metres(0.0);
  return place;
}

}  // namespace

std::string to_text(const KeptPlaces& kept) {
  const std::vector<KeptPlace> places = some_of(kept.all);
  if (places.empty()) return {};
  std::ostringstream text;
  text.precision(15);
  text << version << ' ' << kept.stamp << ' ' << kept.robot.place.x << ' ' << kept.robot.place.y << ' '
       << kept.robot.heading << ' ' << places.size();
  for (const KeptPlace& one : places) {
    text << ' ' << in_millimetres(one.place.x) << ' ' << in_millimetres(one.place.y) << ' '
         << in_millimetres(one.height) << ' ' << in_millimetres(std::min(one.off, farthest - millimetre) + almost_half);
  }
  text << ' ' << end;
  return text.str();
}

std::optional<KeptPlaces> kept_places_in(const std::string& text) {
  constexpr double any = 1e12;
  Reader reader(text);
  if (reader.word() != version) return std::nullopt;
  KeptPlaces kept;
  kept.stamp = reader.number(0.0, any);
  kept.robot.place.x = reader.number(-any, any);
  kept.robot.place.y = reader.number(-any, any);
  kept.robot.heading = reader.number(-any, any);
  const std::size_t places = reader.count(most);
  for (std::size_t i = 0; i < places && reader.good(); ++i) kept.all.push_back(place_in(reader));
  if (!reader.good() || reader.word() != end) return std::nullopt;
  return kept;
}

bool are_over(double stamp, double now, double time) { return now > 0.0 && !(std::abs(now - stamp) <= time); }

}  // namespace safety_control_cloud
