// SPDX-License-Identifier: BSD-3-Clause
#include "footprint_message.hpp"

#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "../../core/path/footprint.hpp"

namespace safety_control_cloud {

Lists footprint_in(const geometry_msgs::PolygonStamped& polygon, const std::string& base_frame) {
  const std::string& frame = polygon.header.frame_id;
  if (frame != base_frame) throw std::invalid_argument("it is in frame '" + frame + "', not in " + base_frame);
  const auto& points = polygon.polygon.points;
  if (points.size() < 3) throw std::invalid_argument("the polygon must have at least 3 corners");
  if (points.size() > most_corners)
    throw std::invalid_argument("the polygon must have at most " + std::to_string(most_corners) + " corners");
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<float>::max_digits10);
  for (const auto& point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) throw std::invalid_argument("each corner must be finite");
    text << (text.tellp() > 0 ? ", [" : "[[") << point.x << ", " << point.y << ']';
  }
  return {text.str() + "]"};
}

}  // namespace safety_control_cloud
