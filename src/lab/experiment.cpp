#include "delone/lab/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/experiments.hpp"

namespace delone::lab {
namespace {

std::string word(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  const double x = std::get<double>(value);
  if (std::isnan(x)) return "-";
  if (x == std::floor(x) && std::abs(x) < 1e15) return fmt::format("{:.0f}", x);
  return fmt::format("{:.4g}", x);
}

std::string exact(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return fmt::format("{}", std::get<double>(value));
}

std::string table_words(const LabTable& table) {
  std::vector<std::size_t> width(table.columns.size());
  for (std::size_t c = 0; c < width.size(); ++c) {
    width[c] = table.columns[c].size();
    for (const auto& row : table.rows) width[c] = std::max(width[c], word(row[c]).size());
  }
  std::string text = table.title.empty() ? "" : table.title + "\n\n";
  const auto line = [&](auto cell) {
    for (std::size_t c = 0; c < width.size(); ++c) {
      text += c == 0 ? fmt::format("{:<{}}", cell(c), width[c]) : fmt::format("  {:>{}}", cell(c), width[c]);
    }
    text += "\n";
  };
  line([&](std::size_t c) { return table.columns[c]; });
  for (const auto& row : table.rows) line([&](std::size_t c) { return word(row[c]); });
  if (!table.note.empty()) text += "\n" + table.note + "\n";
  return text;
}

}  // namespace

Estimate estimate(std::span<const double> values) {
  if (values.empty()) return {};
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  return {mean, values.size() > 1 ? std::sqrt(squares / (n - 1)) : 0.0};
}

std::span<const Experiment> experiments() {
  static const std::vector<Experiment> all{
      triangles_experiment(),   //
      scope_experiment(),       //
      location_experiment(),    //
      batch_experiment(),       //
      spheres_experiment(),     //
      dimensions_experiment(),  //
      flips_experiment(),       //
      optimal_experiment(),     //
      arithmetic_experiment(),  //
      order_k_experiment(),     //
  };
  return all;
}

std::string to_words(const LabReport& report) {
  std::string text = report.heading + "\n";
  for (const LabTable& table : report.tables) text += "\n" + table_words(table);
  return text;
}

std::string to_csv(const LabReport& report) {
  std::string text;
  for (const LabTable& table : report.tables) {
    if (!table.title.empty()) text += "# " + table.title + "\n";
    text += fmt::format("{}\n", fmt::join(table.columns, ","));
    for (const auto& row : table.rows) {
      for (std::size_t c = 0; c < row.size(); ++c) text += (c == 0 ? "" : ",") + exact(row[c]);
      text += "\n";
    }
  }
  return text;
}

}  // namespace delone::lab
