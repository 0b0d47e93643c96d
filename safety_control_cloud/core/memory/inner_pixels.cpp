// SPDX-License-Identifier: BSD-3-Clause
#include "inner_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "kernel/lines.hpp"

namespace safety_control_cloud {
namespace {

using Index = NearPixels::Index;

constexpr std::size_t thin_run = 4;  // successive pixels of a line: fewer are the corner of something, or noise

bool is_inner(const Connected& connected, Index i) { return connected.touched()[i] == lines::AllSides; }

/// In a slot of a line: to tell them by the index takes a division, longer than the rest.
bool is_beside_inner(const NearPixels& found, const Connected& connected, std::size_t line, std::size_t slot) {
  const float ahead = found.ahead[line * found.slots + slot];
  for (std::size_t l = line - std::min<std::size_t>(1, line); l < std::min(line + 2, found.rows.size()); ++l) {
    for (std::size_t s = slot - std::min<std::size_t>(1, slot); s < std::min(slot + 2, found.slots); ++s) {
      const auto other = static_cast<Index>(l * found.slots + s);
      if (is_inner(connected, other) && std::abs(found.ahead[other] - ahead) <= connected.jump()) return true;
    }
  }
  return false;
}

/// Of successive pixels of a line, none of which is inner, those that do not border on inner ones either.
void add_far_from_inner(const NearPixels& found, const Connected& connected, const std::vector<Index>& pixels,
                        std::vector<Index>& to) {
  const std::size_t line = found.line_of(pixels.front()), first = line * found.slots;
  std::size_t run = 0;
  const auto end_run = [&] {
    if (run < thin_run) to.resize(to.size() - run);
    run = 0;
  };
  for (const Index i : pixels) {
    if (is_beside_inner(found, connected, line, i - first)) {
      end_run();
    } else {
      to.push_back(i);
      ++run;
    }
  }
  end_run();
}

void add_thin(const NearPixels& found, const Connected& connected, const Stretch& some, std::vector<Index>& to) {
  std::vector<Index> run;  // of pixels that are not inner: most are too short to be looked around
  const auto end_run = [&] {
    if (run.size() >= thin_run) add_far_from_inner(found, connected, run, to);
    run.clear();
  };
  for (Index i = some.begin; i < some.end; ++i) {
    if (!found.has_pixel(i)) continue;
    if (is_inner(connected, i)) {
      end_run();
    } else {
      run.push_back(i);
    }
  }
  end_run();
}

}  // namespace

std::vector<Index> pixels_of(const NearPixels& found, const Stretches& all) {
  std::vector<Index> pixels;
  for (const Stretch& some : all)
    for (Index i = some.begin; i < some.end; ++i)
      if (found.has_pixel(i)) pixels.push_back(i);
  return pixels;
}

std::vector<Index> inner_and_thin(const NearPixels& found, const Connected& connected, const Stretches& all) {
  std::size_t most = 0, size = 0;
  for (const Stretch& some : all) most += size_of(some);
  const std::unique_ptr<Index[]> listed(new Index[most + lines::longest_vector]);
  std::vector<Index> thin;
  for (const Stretch& some : all) {
    const std::size_t some_inner =
        lines::list_inner(connected.touched().data(), some.begin, some.end, listed.get() + size);
    if (size_of(some) >= some_inner + thin_run) add_thin(found, connected, some, thin);
    size += some_inner;
  }
  std::vector<Index> inner(listed.get(), listed.get() + size);
  if (inner.empty() || thin.empty()) return inner;
  std::vector<Index> both;
  both.reserve(inner.size() + thin.size());
  std::merge(inner.begin(), inner.end(), thin.begin(), thin.end(), std::back_inserter(both));
  return both;
}

}  // namespace safety_control_cloud
