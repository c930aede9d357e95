// Units of work by several processes: order, errors, and workers that are killed.
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "core/error.hpp"
#include "tests/temporary_folder.hpp"
#include "viz/workers.hpp"

using namespace packstone;
using namespace packstone::viz;
using Catch::Matchers::Contains;

namespace {

struct Result {
  std::size_t square;
  pid_t process;
};

UnitResult unit_result(const Result& result) {
  UnitResult bytes(sizeof result);
  std::memcpy(bytes.data(), &result, sizeof result);
  return bytes;
}

Result got(const UnitResult& bytes) {
  Result result{};
  REQUIRE(bytes.size() == sizeof result);
  std::memcpy(&result, bytes.data(), sizeof result);
  return result;
}

/// Squares of the units, after what else is done with them.
WorkInUnits squares(std::size_t count, const std::function<void(std::size_t)>& before, std::vector<Result>& taken) {
  WorkInUnits work{.count = count, .result_bytes = sizeof(Result), .prepare = {}, .take = {}};
  work.prepare = [before] {
    return [before](std::size_t unit) {
      before(unit);
      return unit_result({unit * unit, getpid()});
    };
  };
  work.take = [&taken](std::size_t unit, const UnitResult& bytes) {
    CHECK(unit == taken.size());
    taken.push_back(got(bytes));
  };
  return work;
}

void check_squares(const std::vector<Result>& taken, std::size_t count) {
  REQUIRE(taken.size() == count);
  for (std::size_t k = 0; k < count; ++k) CHECK(taken[k].square == k * k);
}

const auto nothing = [](std::size_t) {};

}  // namespace

TEST_CASE("units are taken in order, by as many processes as asked for") {
  for (const int workers : {1, 2, 5, 40}) {
    std::vector<Result> taken;
    // Later units are done sooner.
    do_units(squares(
                 20, [](std::size_t unit) { usleep(static_cast<useconds_t>(20 - unit) * 200); }, taken),
             workers);
    check_squares(taken, 20);
    std::set<pid_t> processes;
    for (const Result& result : taken) processes.insert(result.process);
    if (workers == 1) CHECK(processes == std::set<pid_t>{getpid()});
    if (workers > 1) CHECK(processes.count(getpid()) == 0);
    CHECK(processes.size() <= static_cast<std::size_t>(workers));
  }
  std::vector<Result> taken;
  do_units(squares(0, nothing, taken), 3);
  CHECK(taken.empty());
}

TEST_CASE("results of any size come as they are") {
  const auto result_of = [](std::size_t unit) {
    return UnitResult(unit % 3 == 0 ? 0 : unit * 100'000, static_cast<std::uint8_t>(unit));
  };
  for (const int workers : {1, 3}) {
    std::size_t taken = 0;
    do_units({.count = 12,
              .result_bytes = 300'000,
              .prepare = [&] { return result_of; },
              .take = [&](std::size_t unit, const UnitResult& result) { taken += result == result_of(unit) ? 1 : 0; }},
             workers);
    CHECK(taken == 12);
  }
}

TEST_CASE("a worker that is killed is replaced and its unit done again") {
  const testing::TemporaryFolder folder;
  std::vector<Result> taken;
  const auto die_once = [&](std::size_t unit) {
    const auto mark = folder / std::to_string(unit);
    if (unit % 3 != 1 || std::filesystem::exists(mark)) return;
    std::ofstream(mark) << "died";
    kill(getpid(), SIGKILL);
  };
  do_units(squares(10, die_once, taken), 3);
  check_squares(taken, 10);
  CHECK(std::filesystem::exists(folder / "7"));
}

TEST_CASE("a unit that kills every worker ends the work, with its number") {
  std::vector<Result> taken;
  const auto die = [](std::size_t unit) {
    if (unit == 4) kill(getpid(), SIGKILL);
  };
  CHECK_THROWS_WITH(do_units(squares(8, die, taken), 2), Contains("frame 4: 3 worker processes died"));
  CHECK(taken.size() <= 4);
}

TEST_CASE("what a worker or the taker throws comes out, of the same kind") {
  for (const int workers : {1, 3}) {
    std::vector<Result> taken;
    const auto input = [](std::size_t unit) {
      if (unit == 3) throw InputError("no field 'x'");
    };
    CHECK_THROWS_AS(do_units(squares(6, input, taken), workers), InputError);
    taken.clear();
    const auto failure = [](std::size_t unit) {
      if (unit == 2) throw RunError("disk full");
    };
    CHECK_THROWS_WITH(do_units(squares(6, failure, taken), workers), "disk full");
    taken.clear();
    WorkInUnits work = squares(6, nothing, taken);
    work.take = [](std::size_t unit, const UnitResult&) {
      if (unit == 1) throw Interrupted("stop");
    };
    CHECK_THROWS_AS(do_units(work, workers), Interrupted);
  }
}
