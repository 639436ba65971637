// Hidden sites by the finite cell that holds them, so that whoever removes the cell can ask them again. Kept only from
// the first removal on: building needs none of it.
#pragma once

#include <algorithm>
#include <cstddef>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"

namespace delone {

class HiddenSites {
 public:
  bool kept() const { return kept_; }
  void keep() { kept_ = true; }

  /// Room for sites and cells below these numbers; on std::bad_alloc nothing has changed.
  void reserve(std::size_t sites, std::size_t cells) {
    if (cells > first_.size()) {
      first_.reserve_more(cells - first_.size());
      first_.resize(first_.capacity(), kGhost);
    }
    if (sites > links_.size()) {
      links_.reserve_more(sites - links_.size());
      links_.resize(links_.capacity(), Link{kGhost, kGhost, kNoCell});
    }
  }

  /// The first site in cell c, then the next one, kGhost behind the last.
  VertexId first(CellId c) const { return raw(c) < first_.size() ? first_[raw(c)] : kGhost; }
  VertexId next(VertexId v) const { return links_[raw(v)].next; }
  /// The cell that holds v, kNoCell when v is not hidden, or nobody knows.
  CellId cell(VertexId v) const { return raw(v) < links_.size() ? links_[raw(v)].cell : kNoCell; }
  bool holds(VertexId v) const { return cell(v) != kNoCell; }

  // These need room, and cannot fail.
  void add(VertexId v, CellId c) {
    const VertexId head = first_[raw(c)];
    links_[raw(v)] = {head, kGhost, c};
    if (head != kGhost) links_[raw(head)].last = v;
    first_[raw(c)] = v;
  }
  void remove(VertexId v) {
    Link& link = links_[raw(v)];
    (link.last == kGhost ? first_[raw(link.cell)] : links_[raw(link.last)].next) = link.next;
    if (link.next != kGhost) links_[raw(link.next)].last = link.last;
    link = {kGhost, kGhost, kNoCell};
  }

  std::size_t memory_bytes() const { return first_.capacity() * sizeof(VertexId) + links_.capacity() * sizeof(Link); }

 private:
  struct Link {
    VertexId next, last;
    CellId cell;
  };

  bool kept_ = false;
  Buffer<VertexId> first_;  // per cell slot
  Buffer<Link> links_;      // per site
};

}  // namespace delone
