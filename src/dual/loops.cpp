#include "dual/loops.hpp"

#include <algorithm>

namespace delone::dual_detail {
namespace {

Corner crossing(const Corner& from, double from_side, const Corner& to, double to_side, Index across) {
  const double share = from_side / (from_side - to_side);
  return {{from.at[0] + share * (to.at[0] - from.at[0]), from.at[1] + share * (to.at[1] - from.at[1])}, across};
}

}  // namespace

double doubled_area(const Corner* begin, const Corner* end) {
  double sum = 0;
  for (const Corner* c = begin; c + 1 < end; ++c) {
    sum += (c->at[0] - begin->at[0]) * (c[1].at[1] - c->at[1]) - (c->at[1] - begin->at[1]) * (c[1].at[0] - c->at[0]);
  }
  return sum;
}

/// On which side of the line each corner lies; whether any lies beyond.
bool LoopCutter::classify(const Loops& region, const HalfPlane& by) {
  side_.resize(region.corners.size());
  bool beyond = false;
  for (std::size_t i = 0; i < side_.size(); ++i) {
    const auto& [x, y] = region.corners[i].at;
    side_[i] = by.normal[0] * x + by.normal[1] * y - by.offset;
    beyond = beyond || side_[i] > 0;
  }
  return beyond;
}

/// The parts of one loop that stay; a loop that stays as a whole is a result.
void LoopCutter::add_chains(const Loops& region, std::size_t begin, std::size_t end, Index across) {
  const auto next = [&](std::size_t i) { return i + 1 == end ? begin : i + 1; };
  const auto stays = [&](std::size_t i) { return side_[i] <= 0; };
  std::size_t start = begin;  // a corner that stays after one that does not
  while (start < end && !(stays(next(start)) && !stays(start))) ++start;
  if (start == end) {
    if (!stays(begin)) return;
    result_.corners.insert(result_.corners.end(), region.corners.begin() + static_cast<std::ptrdiff_t>(begin),
                           region.corners.begin() + static_cast<std::ptrdiff_t>(end));
    result_.ends.push_back(result_.corners.size());
    return;
  }
  std::size_t at = start;
  do {
    const std::size_t to = next(at);
    const Corner& from = region.corners[at];
    if (!stays(at) && stays(to)) {
      chains_.push_back({chain_corners_.size(), 0, 0});
      if (side_[to] < 0)
        chain_corners_.push_back(crossing(from, side_[at], region.corners[to], side_[to], from.across));
    } else if (stays(at)) {
      chain_corners_.push_back(from);
      if (!stays(to)) {
        if (side_[at] < 0) chain_corners_.push_back(crossing(from, side_[at], region.corners[to], side_[to], across));
        chain_corners_.back().across = across;
        chains_.back().end = chain_corners_.size();
      }
    }
    at = to;
  } while (at != start);
}

void LoopCutter::join(const HalfPlane& by) {
  if (chains_.size() == 1) {
    result_.corners.insert(result_.corners.end(), chain_corners_.begin(), chain_corners_.end());
    result_.ends.push_back(result_.corners.size());
    return;
  }
  const auto along = [&](const Corner& c) { return by.normal[0] * c.at[1] - by.normal[1] * c.at[0]; };
  leaving_.clear();
  entering_.clear();
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    entering_.push_back({along(chain_corners_[chains_[i].begin]), i});
    leaving_.push_back({along(chain_corners_[chains_[i].end - 1]), i});
  }
  const auto first = [](const Crossing& a, const Crossing& b) { return a.along < b.along; };
  std::ranges::stable_sort(leaving_, first);
  std::ranges::stable_sort(entering_, first);
  for (std::size_t i = 0; i < chains_.size(); ++i) chains_[leaving_[i].chain].next = entering_[i].chain;
  for (Chain& first_chain : chains_) {
    if (first_chain.begin == first_chain.end) continue;  // is part of a loop
    for (Chain* chain = &first_chain; chain->begin != chain->end; chain = &chains_[chain->next]) {
      result_.corners.insert(result_.corners.end(), chain_corners_.begin() + static_cast<std::ptrdiff_t>(chain->begin),
                             chain_corners_.begin() + static_cast<std::ptrdiff_t>(chain->end));
      chain->begin = chain->end;
    }
    result_.ends.push_back(result_.corners.size());
  }
}

void LoopCutter::cut(Loops& region, const HalfPlane& by, Index across) {
  if (!classify(region, by)) return;
  result_.clear();
  chain_corners_.clear();
  chains_.clear();
  std::size_t begin = 0;
  for (const std::size_t end : region.ends) {
    add_chains(region, begin, end, across);
    begin = end;
  }
  if (!chains_.empty()) join(by);
  // What only touches the line has no area.
  region.clear();
  begin = 0;
  for (const std::size_t end : result_.ends) {
    const Corner* corners = result_.corners.data();
    if (end - begin >= 3 && doubled_area(corners + begin, corners + end) != 0) {
      region.corners.insert(region.corners.end(), corners + begin, corners + end);
      region.ends.push_back(region.corners.size());
    }
    begin = end;
  }
}

}  // namespace delone::dual_detail
