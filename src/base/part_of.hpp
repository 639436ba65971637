// Progress of work that has parts.
#pragma once

#include "delone/base/progress.hpp"

namespace delone {

/// What a part that takes the work from one share to another tells, told to who follows the whole. Valid as long as
/// `whole`.
inline Progress part_of(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double done) { return whole(from + done * (to - from)); };
}

}  // namespace delone
