// Sequences of insertions, removals and moves on small point sets: after each the triangulation must be the one that
// building from the points as they are gives, rows and statuses included. Input bytes: dimension and weights, how
// coordinates are coded, then operations, each a byte with its row or coordinates behind it.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "delone/build/insert.hpp"
#include "delone/remove/move.hpp"
#include "delone/remove/remove.hpp"
#include "fuzz/bytes.hpp"
#include "support/ledger.hpp"

namespace {

using delone::Index;
using delone::test::Ledger;

constexpr std::size_t kMostPoints[] = {0, 12, 12, 10, 9, 8};

Ledger::Entry entry(delone::fuzz::Bytes& bytes, const Ledger& ledger, int coding, int weight_coding) {
  Ledger::Entry e;
  for (int axis = 0; axis < ledger.dimension; ++axis) e.point.push_back(delone::fuzz::number(bytes, coding));
  if (ledger.weighted) e.weight = delone::fuzz::number(bytes, weight_coding);
  return e;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  delone::fuzz::Bytes bytes(std::span(data, size));
  const std::uint8_t shape = bytes.next();
  Ledger ledger{1 + shape % 5, (shape & 16) != 0, {}};
  const int coding = bytes.next() % 8;
  const int weight_coding = bytes.next() % 8;
  delone::AnyTriangulation t(ledger.dimension, ledger.weighted);
  while (!bytes.empty() && ledger.rows.size() < 64) {
    const std::uint8_t byte = bytes.next();
    const std::vector<Index> present = ledger.present();
    const int verb = present.empty() ? 0 : byte % 4;
    const Index row = present.empty() ? 0 : present[byte / 4 % present.size()];
    if (verb <= 1) {
      if (present.size() == kMostPoints[ledger.dimension]) continue;
      const auto e = entry(bytes, ledger, coding, weight_coding);
      delone::insert(t, e.point, e.weight);
      ledger.rows.emplace_back(e);
    } else if (verb == 2) {
      delone::remove(t, row);
      ledger.rows[row].reset();
    } else {
      const auto e = entry(bytes, ledger, coding, weight_coding);
      delone::move(t, row, e.point, ledger.weighted ? std::optional(e.weight) : std::nullopt);
      ledger.rows[row] = e;
    }
    if (const std::string fault = delone::test::differs_from_building(t, ledger); !fault.empty()) {
      std::fprintf(stderr, "edit_fuzz: after %zu rows, verb %d, row %zu: %s\n", ledger.rows.size(), verb,
                   static_cast<std::size_t>(row), fault.c_str());
      std::abort();
    }
  }
  return 0;
}
