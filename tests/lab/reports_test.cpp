#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "delone/base/errors.hpp"
#include "lab/experiments.hpp"

namespace delone::lab {
namespace {

/// Experiments of [GKS92] with the least sizes that they take.
std::vector<std::pair<Experiment, std::size_t>> small_experiments() {
  return {{triangles_experiment(), 10}, {scope_experiment(), 3},    {location_experiment(), 10},
          {batch_experiment(), 10},     {order_k_experiment(), 25}, {spheres_experiment(), 20}};
}

TEST(Reports, every_row_has_a_value_for_every_column) {
  for (const auto& [experiment, n] : small_experiments()) {
    for (const std::size_t size : {n, n + 120}) {
      const LabOptions options{.n = experiment.name == "scope" ? n + 10 : size, .runs = 2};
      const LabReport report = experiment.run(options);
      ASSERT_FALSE(report.tables.empty()) << experiment.name;
      for (const LabTable& table : report.tables) {
        for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.title;
      }
      for (const Panel& panel : report.panels) {
        for (const Series& series : panel.series) EXPECT_FALSE(series.points.empty()) << panel.title << series.name;
      }
      EXPECT_GT(experiment.seconds(options), 0);
    }
  }
}

TEST(Reports, equal_options_give_equal_reports) {
  for (const auto& [experiment, n] : small_experiments()) {
    const LabOptions options{.n = n, .runs = 2, .seed = 7};
    EXPECT_EQ(to_csv(experiment.run(options)), to_csv(experiment.run(options))) << experiment.name;
  }
}

TEST(Reports, sizes_without_sense_are_refused) {
  for (const auto& [experiment, n] : small_experiments())
    EXPECT_THROW(experiment.run({.n = n - 1}), InputError) << experiment.name;
}

TEST(Reports, callers_may_stop) {
  for (const auto& [experiment, n] : small_experiments())
    EXPECT_THROW(experiment.run({.n = n, .progress = [](double) { return false; }}), Cancelled) << experiment.name;
}

}  // namespace
}  // namespace delone::lab
