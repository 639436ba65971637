// Facets go into one bucket per smallest row; within a bucket, sorting brings equal ones together. The sort compares a
// hash of the other rows first and the rows themselves when the hashes agree.
#include "check/facet_match.hpp"

#include <algorithm>
#include <cstdint>

#include "check/chunks.hpp"

namespace delone::check_detail {
namespace {

struct Entry {
  std::uint64_t hash;
  Index facet;
};

class Matcher {
 public:
  Matcher(std::span<const Index> simplices, int corners, std::size_t rows)
      : simplices_(simplices), corners_(static_cast<std::size_t>(corners)), offsets_(rows + 1) {}

  FacetMatch run(int threads) {
    fill_buckets();
    FacetMatch match;
    match.twin.assign(simplices_.size(), kNone);
    const std::size_t buckets = offsets_.size() - 1;
    std::vector<std::vector<std::vector<Index>>> crowded((buckets + kChunk - 1) / kChunk);
    for_chunks(buckets, threads, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      for (std::size_t bucket = begin; bucket < end; ++bucket) {
        pair_up(std::span(entries_).subspan(offsets_[bucket], offsets_[bucket + 1] - offsets_[bucket]), match.twin,
                crowded[chunk]);
      }
    });
    for (auto& some : crowded) match.crowded.insert(match.crowded.end(), some.begin(), some.end());
    std::sort(match.crowded.begin(), match.crowded.end());
    return match;
  }

 private:
  /// The smallest row of a facet; a facet without rows goes into bucket 0.
  Index bucket(std::size_t facet) const {
    if (corners_ == 1) return 0;
    const std::size_t simplex = facet / corners_ * corners_;
    return simplices_[simplex + (facet == simplex ? 1 : 0)];
  }

  std::uint64_t hash(std::size_t facet) const {
    const std::size_t simplex = facet / corners_ * corners_;
    std::uint64_t h = 0;
    for (std::size_t i = simplex; i < simplex + corners_; ++i) {
      if (i != facet) h = (h ^ simplices_[i]) * 0x9E37'79B9'7F4A'7C15U;
    }
    return h;
  }

  void fill_buckets() {
    const std::size_t count = simplices_.size();
    for (std::size_t facet = 0; facet < count; ++facet) ++offsets_[bucket(facet) + std::size_t{1}];
    for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
    entries_.resize(count);
    std::vector<std::size_t> place(offsets_.begin(), offsets_.end() - 1);
    for (std::size_t facet = 0; facet < count; ++facet) {
      entries_[place[bucket(facet)]++] = {hash(facet), static_cast<Index>(facet)};
    }
  }

  /// Negative, zero or positive as the rows of `a` come before, equal or come after those of `b`.
  int compare_rows(std::size_t a, std::size_t b) const {
    std::size_t i = a / corners_ * corners_;
    std::size_t j = b / corners_ * corners_;
    for (std::size_t left = corners_ - 1; left > 0; --left, ++i, ++j) {
      if (i == a) ++i;
      if (j == b) ++j;
      if (simplices_[i] != simplices_[j]) return simplices_[i] < simplices_[j] ? -1 : 1;
    }
    return 0;
  }

  void pair_up(std::span<Entry> entries, std::vector<Index>& twin, std::vector<std::vector<Index>>& crowded) const {
    std::sort(entries.begin(), entries.end(), [this](const Entry& a, const Entry& b) {
      if (a.hash != b.hash) return a.hash < b.hash;
      const int order = compare_rows(a.facet, b.facet);
      return order != 0 ? order < 0 : a.facet < b.facet;
    });
    for (std::size_t begin = 0; begin < entries.size();) {
      std::size_t end = begin + 1;
      while (end < entries.size() && entries[end].hash == entries[begin].hash &&
             compare_rows(entries[begin].facet, entries[end].facet) == 0) {
        ++end;
      }
      if (end - begin == 2) {
        twin[entries[begin].facet] = entries[begin + 1].facet;
        twin[entries[begin + 1].facet] = entries[begin].facet;
      } else if (end - begin > 2) {
        crowded.emplace_back();
        for (std::size_t i = begin; i < end; ++i) crowded.back().push_back(entries[i].facet);
      }
      begin = end;
    }
  }

  std::span<const Index> simplices_;
  std::size_t corners_;
  std::vector<std::size_t> offsets_;
  std::vector<Entry> entries_;
};

}  // namespace

FacetMatch match_facets(std::span<const Index> simplices, int corners, std::size_t rows, int threads) {
  return Matcher(simplices, corners, std::max<std::size_t>(rows, 1)).run(threads);
}

}  // namespace delone::check_detail
