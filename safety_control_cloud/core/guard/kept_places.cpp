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

constexpr const char* version = "places-3";
constexpr const char* end = "end";
constexpr const char* no_name = "-";
constexpr std::size_t most_sensors = 100;
constexpr double close_by = 0.04, layer = 0.1;  ///< [m] across and up
constexpr std::size_t most = 2000;              ///< places
constexpr double farthest = 1e5;                ///< [m] farther than anybody drives in memory_time
constexpr double millimetre = 1e-3;             ///< [m]
constexpr double almost_half = 0.499e-3;        ///< [m] so that it is rounded up

std::vector<KeptPlace> some_of(const std::vector<KeptPlace>& all) {
  std::map<std::array<long, 4>, KeptPlace> some;
  for (const KeptPlace& one : all) {
    const std::array<long, 4> cell = {std::lround(one.place.x / close_by), std::lround(one.place.y / close_by),
                                      std::lround(one.height / layer), static_cast<long>(one.sensor)};
    const Point2 middle{close_by * static_cast<double>(cell[0]), close_by * static_cast<double>(cell[1])};
    const double off = one.off + length_of(one.place - middle);
    KeptPlace& kept = some.emplace(cell, KeptPlace{middle, one.height, off, one.sensor}).first->second;
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

std::vector<std::vector<KeptPlace>> by_sensor(const std::vector<KeptPlace>& all) {
  std::vector<std::vector<KeptPlace>> of_each;
  for (const KeptPlace& one : all) {
    of_each.resize(std::max(of_each.size(), one.sensor + 1));
    of_each[one.sensor].push_back(one);
  }
  return of_each;
}

std::string name_in(const std::vector<std::string>& names, std::size_t sensor) {
  return sensor < names.size() && !names[sensor].empty() ? names[sensor] : no_name;
}

void write(const std::vector<KeptPlace>& places, std::ostream& to) {
  to << ' ' << places.size();
  for (const KeptPlace& one : places) {
    to << ' ' << in_millimetres(one.place.x) << ' ' << in_millimetres(one.place.y) << ' ' << in_millimetres(one.height)
       << ' ' << in_millimetres(std::min(one.off, farthest - millimetre) + almost_half);
  }
}

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
  if (places.empty() && kept.robot) return {};
  std::ostringstream text;
  text.precision(15);
  text << version << ' ' << kept.stamp << ' ' << (kept.robot ? 1 : 0);
  if (kept.robot) text << ' ' << kept.robot->place.x << ' ' << kept.robot->place.y << ' ' << kept.robot->heading;
  const auto of_each = by_sensor(places);
  text << ' ' << of_each.size();
  for (std::size_t sensor = 0; sensor < of_each.size(); ++sensor) {
    text << ' ' << name_in(kept.sensors, sensor);
    write(of_each[sensor], text);
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
  if (reader.count(1) == 1) {
    kept.robot->place.x = reader.number(-any, any);
    kept.robot->place.y = reader.number(-any, any);
    kept.robot->heading = reader.number(-any, any);
  } else {
    kept.robot.reset();
  }
  const std::size_t sensors = reader.count(most_sensors);
  for (std::size_t sensor = 0; sensor < sensors && reader.good(); ++sensor) {
    const std::string name = reader.word();
    kept.sensors.push_back(name == no_name ? "" : name);
    const std::size_t places = reader.count(most);
    for (std::size_t i = 0; i < places && reader.good(); ++i) {
      kept.all.push_back(place_in(reader));
      kept.all.back().sensor = sensor;
    }
  }
  if (!reader.good() || reader.word() != end) return std::nullopt;
  return kept;
}

bool are_over(double stamp, double now, double time) { return now > 0.0 && !(std::abs(now - stamp) <= time); }

}  // namespace safety_control_cloud
