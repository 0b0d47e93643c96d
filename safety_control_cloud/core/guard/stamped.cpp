// SPDX-License-Identifier: BSD-3-Clause
#include "stamped.hpp"

#include "../text/words.hpp"

namespace safety_control_cloud {

/// Written so that NaN is refused.
std::optional<std::string> refusal_of_stamp(double stamp, double now, const StampLimits& limits) {
  if (!(stamp > 0.0)) return "the command's stamp is 0: nobody knows how old it is";
  const double age = now - stamp;
  if (!(age <= limits.greatest_age))
    return words("the command is ", measured(age, "s"), " old, more than command_max_age");
  if (limits.tolerance > 0.0 && age < -limits.tolerance)
    return words("the command is stamped ", measured(-age, "s"), " ahead of now, more than stamp_tolerance");
  return std::nullopt;
}

}  // namespace safety_control_cloud
