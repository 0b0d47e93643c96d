// SPDX-License-Identifier: BSD-3-Clause
// A plugin's parameters in its SDF: one that gazebo_ros' own plugin does not read is a mistake, and ends the server.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <sdf/sdf.hh>

namespace standin {

class Parameters {
 public:
  Parameters(sdf::ElementPtr plugin, const std::vector<std::string>& known) : plugin_(std::move(plugin)) {
    for (auto element = plugin_->GetFirstElement(); element; element = element->GetNextElement()) {
      if (std::find(known.begin(), known.end(), element->GetName()) == known.end()) refuse(element->GetName());
    }
  }

  template <typename T>
  T value(const std::string& name, const T& otherwise) const {
    return plugin_->Get<T>(name, otherwise).first;
  }

 private:
  void refuse(const std::string& name) const {
    std::fprintf(stderr, "%s does not know <%s>\n", plugin_->Get<std::string>("filename").c_str(), name.c_str());
    std::_Exit(EXIT_FAILURE);  // an exception would only leave the plugin out
  }

  sdf::ElementPtr plugin_;
};

}  // namespace standin
