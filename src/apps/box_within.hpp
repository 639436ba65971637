// A box within a region, of a size that the region allows.
#pragma once

#include <array>

#include "delone/dual/region.hpp"

namespace delone {

struct Box {
  std::array<double, 3> low{}, high{};  ///< 0 on the last axis of the plane
};

/// A box within the region, up to rounding: that of a box is the region itself.
Box box_within(const Region& region);

}  // namespace delone
