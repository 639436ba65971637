#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "command.hpp"
#include "report.hpp"

namespace delone::cli {
namespace {

/// What cells are called in dimensions that have a word for them.
const char* cell_name(int affine_dimension, std::size_t count) {
  switch (affine_dimension) {
    case 1:
      return count == 1 ? "segment" : "segments";
    case 2:
      return count == 1 ? "triangle" : "triangles";
    case 3:
      return count == 1 ? "tetrahedron" : "tetrahedra";
    default:
      return "";
  }
}

std::string memory(std::size_t bytes) {
  if (bytes < 1'000'000) return fmt::format("{:.0f} kB", static_cast<double>(bytes) / 1e3);
  return fmt::format("{:.4g} MB", static_cast<double>(bytes) / 1e6);
}

/// "x, y", or "columns 1, 2" where the file names none.
std::string names_of_axes(const std::vector<std::string>& names) {
  const auto is_number = [](const std::string& name) {
    return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
  };
  const bool unnamed = !names.empty() && std::ranges::all_of(names, is_number);
  return (unnamed ? "column" + std::string(names.size() == 1 ? " " : "s ") : "") + joined(names);
}

/// "0.01 s (read 0.00, ...)", phases that took part only.
std::string times(const Summary& summary) {
  double writing = 0;
  for (const Written& written : summary.written) writing += written.seconds;
  const BuildStatistics& build = summary.statistics;
  std::vector<std::string> phases{
      fmt::format("read {:.2f}", summary.read_seconds),
      fmt::format("triangulate {:.2f}", build.order_seconds + build.insert_seconds + build.finish_seconds)};
  if (summary.check) phases.push_back(fmt::format("check {:.2f}", summary.check_seconds));
  if (!summary.written.empty()) phases.push_back(fmt::format("write {:.2f}", writing));
  return fmt::format("{:.2f} s ({})", summary.total_seconds, joined(phases));
}

}  // namespace

std::string to_words(const Summary& summary) {
  std::vector<std::pair<std::string, std::string>> counts{
      {"points", grouped(summary.rows)},           {"vertices", grouped(summary.vertices)},
      {"duplicates", grouped(summary.duplicates)}, {"hidden", grouped(summary.hidden)},
      {"cells", grouped(summary.cells)},           {"hull facets", grouped(summary.hull_facets)}};
  if (summary.merged_cells) counts.emplace_back("merged cells", grouped(*summary.merged_cells));
  std::size_t width = 0;
  for (const auto& [name, number] : counts) width = std::max(width, number.size());

  std::string text;
  for (const auto& [name, number] : counts) {
    std::string remark;
    if (name == "points") {
      remark = fmt::format("{} dimension{}: {}{}", summary.dimension, summary.dimension == 1 ? "" : "s",
                           names_of_axes(summary.coordinate_names), summary.weighted ? "; weighted" : "");
      if (summary.affine_dimension < summary.dimension)
        remark += fmt::format("; all in a flat of dimension {}", summary.affine_dimension);
    } else if (name == "cells") {
      remark = cell_name(summary.affine_dimension, summary.cells);
    }
    text += fmt::format("{:<12}  {:>{}}{}{}\n", name, number, width, remark.empty() ? "" : "  ", remark);
  }
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("{:<12}  {}\n", name, value);
  };
  line("time", times(summary));
  line("memory", memory(summary.memory_bytes));
  if (summary.check)
    line("exact check", summary.check->passed()
                            ? "passed"
                            : "FAILED: " + counted(summary.check->violation_count, "violation", "violations"));
  for (const Written& written : summary.written)
    if (written.path != "-") line("wrote", joined(written.files));
  return text;
}

std::string to_json_text(const Summary& summary) {
  Json json;
  json["version"] = DELONE_VERSION;
  json["input"] = summary.input;
  json["rows"] = summary.rows;
  json["dimension"] = summary.dimension;
  json["affine_dimension"] = summary.affine_dimension;
  json["coordinates"] = summary.coordinate_names;
  json["weighted"] = summary.weighted;
  json["vertices"] = summary.vertices;
  json["duplicates"] = summary.duplicates;
  json["hidden"] = summary.hidden;
  json["cells"] = summary.cells;
  json["hull_facets"] = summary.hull_facets;
  if (summary.merged_cells) json["merged_cells"] = *summary.merged_cells;
  if (summary.canonical_hash) json["canonical_hash"] = *summary.canonical_hash;
  json["check"] = summary.check ? to_json(*summary.check) : Json(nullptr);
  json["memory_bytes"] = summary.memory_bytes;
  json["threads"] = summary.threads;
  json["method"] = summary.method;

  const BuildStatistics& build = summary.statistics;
  Json seconds;
  seconds["read"] = rounded(summary.read_seconds);
  seconds["order"] = rounded(build.order_seconds);
  seconds["insert"] = rounded(build.insert_seconds);
  seconds["finish"] = rounded(build.finish_seconds);
  seconds["export"] = rounded(summary.export_seconds);
  seconds["hash"] = rounded(summary.hash_seconds);
  if (summary.check) seconds["check"] = rounded(summary.check_seconds);
  double writing = 0;
  for (const Written& written : summary.written) writing += written.seconds;
  if (!summary.written.empty()) seconds["write"] = rounded(writing);
  seconds["total"] = rounded(summary.total_seconds);
  json["seconds"] = std::move(seconds);

  const PredicateStats& predicates = build.predicates;
  json["predicates"] = {
      {"orient_filter", predicates.orient_filter},     {"orient_exact", predicates.orient_exact},
      {"conflict_filter", predicates.conflict_filter}, {"conflict_adaptive", predicates.conflict_adaptive},
      {"conflict_exact", predicates.conflict_exact},   {"conflict_symbolic", predicates.conflict_symbolic}};
  json["walk"] = {{"steps", build.walk_steps}, {"fallbacks", build.walk_fallbacks}};
  json["cells_created"] = build.cells_created;
  json["flips"] = build.flips;
  json["history_steps"] = build.history_steps;
  json["written"] = Json::array();
  for (const Written& written : summary.written)
    json["written"].push_back(
        {{"output", written.path}, {"files", written.files}, {"seconds", rounded(written.seconds)}});
  return to_text(json);
}

}  // namespace delone::cli
