// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace safety_control_cloud {

/// A place or a direction in base_frame, seen from above: x forward, y left (REP 103), in metres unless said otherwise.
struct Point2 {
  double x = 0.0;
  double y = 0.0;
};

inline Point2 operator+(const Point2& a, const Point2& b) { return {a.x + b.x, a.y + b.y}; }
inline Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
inline Point2 operator*(double factor, const Point2& a) { return {factor * a.x, factor * a.y}; }

inline double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }
inline double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
inline Point2 turned_left(const Point2& a) { return {-a.y, a.x}; }
inline double length_of(const Point2& a) { return std::hypot(a.x, a.y); }
inline bool is_finite(const Point2& a) { return std::isfinite(a.x) && std::isfinite(a.y); }

/// What is nearer to a boundary than this counts as on it: far below every sensor's noise, far above rounding.
constexpr double touch = 1e-9;  // [m]

}  // namespace safety_control_cloud
