// Sites that repeat a vertex: same place, same weight.
#pragma once

#include <cstddef>
#include <ranges>
#include <set>
#include <span>
#include <utility>

#include "delone/base/buffer.hpp"
#include "delone/base/ids.hpp"

namespace delone {

class Duplicates {
 public:
  /// Where a site waits: the vertex that it repeats, and its own row. Ordered by vertex, then by row.
  using Entry = std::pair<VertexId, Index>;

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.end(); }

  /// The vertex that a site repeats, or kGhost when it repeats none.
  VertexId vertex_of(VertexId site) const {
    return raw(site) < vertex_of_.size() ? VertexId{vertex_of_[raw(site)]} : kGhost;
  }
  /// The entries of one vertex, by ascending row.
  auto at(VertexId vertex) const {
    return std::ranges::subrange(entries_.lower_bound({vertex, 0}), entries_.lower_bound({vertex, kNone}));
  }

  /// Notes that `site`, which will have the given row, repeats `vertex`. On std::bad_alloc nothing has changed.
  void add(VertexId site, VertexId vertex, Index row) {
    if (raw(site) >= vertex_of_.size()) {
      const std::size_t missing = raw(site) + std::size_t{1} - vertex_of_.size();
      vertex_of_.reserve_more(missing);
      vertex_of_.resize(vertex_of_.size() + missing, kNone);
    }
    entries_.insert({vertex, row});
    vertex_of_[raw(site)] = raw(vertex);
  }
  /// An entry that is out, and can be put back without memory.
  using Node = std::set<Entry>::node_type;
  Node take(VertexId site, Index row) {
    Node node = entries_.extract({vertex_of(site), row});
    vertex_of_[raw(site)] = kNone;
    return node;
  }
  void put_back(Node node, VertexId site) {
    vertex_of_[raw(site)] = raw(node.value().first);
    entries_.insert(std::move(node));
  }
  /// The site that waits under an entry moves to another vertex, or its row changes. Cannot fail.
  void change(const Entry& from, VertexId site, const Entry& to) {
    Node node = entries_.extract(from);
    node.value() = to;
    put_back(std::move(node), site);
  }

  /// Row r of every entry becomes names[r]; names ascend.
  void rename_rows(std::span<const Index> names) {
    std::set<Entry> renamed;
    for (const auto& [vertex, row] : entries_) renamed.insert(renamed.end(), {vertex, names[row]});
    entries_.swap(renamed);
  }

  std::size_t memory_bytes() const {
    constexpr std::size_t kNode = 4 * sizeof(void*) + sizeof(Entry);
    return vertex_of_.capacity() * sizeof(Index) + entries_.size() * kNode;
  }

 private:
  std::set<Entry> entries_;
  Buffer<Index> vertex_of_;  // per site, as far as needed; kNone for those that repeat nothing
};

}  // namespace delone
