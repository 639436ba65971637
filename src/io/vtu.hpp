// VTK's UnstructuredGrid in XML, which ParaView opens: one appended block of raw little-endian arrays.
// Format: "VTK File Formats" of the VTK documentation, XML formats. Each array is preceded by its length in bytes.
#pragma once

#include <cstdint>
#include <ranges>
#include <string>
#include <string_view>

#include "io/output.hpp"

namespace delone::io {

/// The XML that announces the arrays, each at its place in the block that follows it.
class VtuHead {
 public:
  VtuHead(std::size_t points, std::size_t cells);

  void begin(std::string_view section);  ///< "Points", "Cells", "PointData", "CellData"
  void array(std::string_view type, std::string_view name, std::size_t bytes, std::string_view more = "");
  void end(std::string_view section);
  /// All of it; the arrays follow in the order in which they were announced, and then kVtuTail.
  std::string finish();

 private:
  std::string text_;
  std::size_t offset_ = 0;
};

inline constexpr std::string_view kVtuTail = "\n  </AppendedData>\n</VTKFile>\n";

/// An array after its length in bytes.
template <class T, class Numbers>
void put_array(Output& out, const Numbers& numbers) {
  out.put<std::uint64_t>(std::ranges::size(numbers) * sizeof(T));
  out.put_all<T>(numbers);
}

}  // namespace delone::io
