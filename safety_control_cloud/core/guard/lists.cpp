// SPDX-License-Identifier: BSD-3-Clause
#include "lists.hpp"

#include <locale>
#include <sstream>

namespace safety_control_cloud {
namespace {

/// Takes the next sign that is no space, if it is this one.
bool take(std::istream& text, char sign) {
  if ((text >> std::ws).peek() != sign) return false;
  text.get();
  return true;
}

bool take_row(std::istream& text, std::vector<double>& row) {
  if (!take(text, '[')) return false;
  do {
    double number = 0.0;
    if (!(text >> number)) return false;
    row.push_back(number);
  } while (take(text, ','));
  return take(text, ']');
}

}  // namespace

std::optional<std::vector<std::vector<double>>> lists_in(const Lists& lists, std::size_t width) {
  std::vector<std::vector<double>> found;
  std::istringstream text(lists.text);
  text.imbue(std::locale::classic());
  if ((text >> std::ws).eof()) return found;
  if (!take(text, '[')) return std::nullopt;
  if (take(text, ']')) return (text >> std::ws).eof() ? std::optional(found) : std::nullopt;
  do {
    std::vector<double> row;
    if (!take_row(text, row) || row.size() != width) return std::nullopt;
    found.push_back(std::move(row));
  } while (take(text, ','));
  if (!take(text, ']') || !(text >> std::ws).eof()) return std::nullopt;
  return found;
}

}  // namespace safety_control_cloud
