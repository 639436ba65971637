// Any bytes, in any format, are read or refused with an InputError of one line. What is read is finite and
// rectangular; ids of cells are within range; a region has an area or a volume.
// The first byte chooses the format, the second the options; the rest is the file.
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "delone/base/errors.hpp"
#include "io/readers.hpp"

namespace {

using namespace delone;
using namespace delone::io;

void require(bool condition) {
  if (!condition) std::abort();
}

ReadOptions options_of(unsigned char choice) {
  ReadOptions options;
  if ((choice & 1U) != 0) options.attributes = true;
  if ((choice & 2U) != 0) options.radii = "last";
  if ((choice & 4U) != 0) options.weights = "1";
  if ((choice & 8U) != 0) options.columns = {"2", "x"};
  if ((choice & 16U) != 0) options.columns = {"1", "2"};
  if ((choice & 32U) != 0) options.dimension = 2;
  return options;
}

void require_sound(const PointTable& table) {
  require(table.dimension >= 1);
  require(table.coordinate_names.size() == static_cast<std::size_t>(table.dimension));
  require(table.coordinates.size() % static_cast<std::size_t>(table.dimension) == 0);
  require(table.weights.empty() || table.weights.size() == table.size());
  require_finite(table.view());
  for (const Attribute& attribute : table.attributes) {
    require(attribute.numbers.size() + attribute.texts.size() == table.size());
  }
}

template <class Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string message = error.what();
    require(!message.empty() && message.find('\n') == std::string::npos);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size < 2) return 0;
  constexpr std::array kPoints{"a.csv", "a.npy", "a.node", "a.xyz", "a.ply", "a.obj", "a.off"};
  constexpr std::array kCells{"a.cells", "a.npy", "a.ele", "a.vtu", "a.ply", "a.obj", "a.off", "a.geojson"};
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 2, size - 2);
  const std::size_t choice = data[0] % (kPoints.size() + kCells.size() + 1);
  if (choice < kPoints.size()) {
    read_or_refuse([&] { require_sound(read_points_from_memory(kPoints[choice], bytes, options_of(data[1]))); });
    return 0;
  }
  if (choice == kPoints.size() + kCells.size()) {
    read_or_refuse([&] { require(read_region_from_memory("a", bytes, 2 + data[1] % 2).measure() > 0); });
    return 0;
  }
  read_or_refuse([&] {
    const CellTable cells = read_cells_from_memory(kCells[choice - kPoints.size()], bytes, data[1]);
    require(cells.vertices.size() == cells.size() * static_cast<std::size_t>(cells.corners));
    for (const Index row : cells.vertices) require(row < data[1]);
  });
  return 0;
}
