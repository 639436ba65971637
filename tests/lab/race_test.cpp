#include "delone/lab/race.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <stdexcept>

#include "io/files.hpp"

namespace delone::lab {
namespace {

using testing::ElementsAre;

/// A program that says `lines`, and fails where the peer is called bad.
std::string stand_in(const io::Directory& directory, const std::string& lines) {
  const std::string path = directory / "worker";
  std::ofstream(path) << "#!/bin/sh\n[ $1 != bad ] || exit 1\ncat <<.\n" << lines << "\nasked $8\n.\n";
  chmod(path.c_str(), 0700);
  return path;
}

constexpr const char* kLines = "seconds 2\nprocessor 2\ncells 7\nvertices 5\nbytes 99\nwalk_steps 12";

const Workload kPoints{"points", "uniform", 9};

TEST(Race, spread_has_the_median_of_odd_and_even_numbers) {
  EXPECT_EQ(spread({3, 1, 2}).median, 2);
  EXPECT_EQ(spread({4, 1, 2, 3}).median, 2.5);
  EXPECT_EQ(spread({3, 1, 2}).least, 1);
  EXPECT_EQ(spread({3, 1, 2}).most, 3);
}

TEST(Race, contestants_take_turns_and_the_order_turns) {
  const io::Directory directory;
  const std::string worker = stand_in(directory, kLines);
  std::vector<Contestant> race;
  for (const char* name : {"a", "b", "c"}) race.push_back({name, worker, name, kPoints});
  std::vector<std::string> runs;
  alternate(race, 3, [&](const Contestant& c) { runs.push_back(c.label); });
  EXPECT_THAT(runs, ElementsAre("a", "b", "c", "b", "c", "a", "c", "a", "b"));
  EXPECT_EQ(race[0].samples.size(), 3U);
}

TEST(Race, a_sample_is_what_the_worker_says) {
  const io::Directory directory;
  std::vector<Contestant> race{
      {"a", stand_in(directory, kLines), "a", {.title = "points", .kind = "uniform", .n = 9, .repeats = 4}}};
  alternate(race, 1, [](const Contestant&) {});
  const Sample& sample = race[0].samples.at(0);
  EXPECT_EQ(sample.seconds, 2);
  EXPECT_EQ(sample.cells, 7U);
  EXPECT_EQ(sample.bytes, 99U);
  EXPECT_GT(sample.peak_bytes, 0U);
  EXPECT_EQ(sample.counts, (std::map<std::string, double>{{"walk_steps", 12}, {"asked", 4}}));
  EXPECT_FALSE(sample.disturbed);
}

TEST(Race, a_run_that_shares_its_processor_is_disturbed) {
  const io::Directory directory;
  std::vector<Contestant> race{
      {"a", stand_in(directory, "seconds 2\nprocessor 1\ncells 7\nvertices 5\nbytes 99"), "a", kPoints}};
  alternate(race, 1, [](const Contestant&) {});
  EXPECT_TRUE(race[0].samples.at(0).disturbed);
}

TEST(Race, only_a_rival_that_may_fail_may_fail) {
  const io::Directory directory;
  const std::string worker = stand_in(directory, kLines);
  std::vector<Contestant> race{{"a", worker, "bad", kPoints, {}, true}, {"b", worker, "b", kPoints}};
  alternate(race, 2, [](const Contestant&) {});
  EXPECT_TRUE(race[0].failed);
  EXPECT_EQ(race[1].samples.size(), 2U);
  race[0].may_fail = race[0].failed = false;
  EXPECT_THROW(alternate(race, 1, [](const Contestant&) {}), std::runtime_error);
}

TEST(Race, a_worker_that_says_nothing_is_named) {
  const io::Directory directory;
  std::vector<Contestant> race{{"a", stand_in(directory, "cells 7"), "a", kPoints}};
  try {
    alternate(race, 1, [](const Contestant&) {});
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), directory / "worker" + ": expected a line 'seconds'");
  }
}

}  // namespace
}  // namespace delone::lab
