// Ranks through MPI, which is not even initialised where one process works alone: that takes half a second.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#define OMPI_SKIP_MPICXX 1  // of Open MPI's header only the interface of the standard
#define MPICH_SKIP_MPICXX 1
#include <fmt/format.h>
#include <mpi.h>
#include <omp.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/launched.hpp"
#include "viz/ranks.hpp"

namespace packstone::viz {

namespace {

constexpr int first_rank = 0;
enum Tag { order_tag, answer_tag, result_tag };
constexpr std::size_t no_more = std::numeric_limits<std::size_t>::max();  ///< as an order: go; as an answer: gone
constexpr std::size_t largest_message = std::size_t{1} << 30;             ///< MPI counts in int
constexpr useconds_t interval = 200;  ///< to look for orders: MPI itself would hold the processor [us]

/// Calls send_or_receive(part, bytes of it) for all parts of a result.
template <class Bytes, class Action>
void in_messages(Bytes* bytes, std::size_t count, const Action& send_or_receive) {
  for (std::size_t done = 0; done < count; done += largest_message) {
    send_or_receive(bytes + done, static_cast<int>(std::min(largest_message, count - done)));
  }
}

bool waits_for_me(int from, Tag tag, MPI_Status& status) {
  int there = 0;
  MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, &status);
  return there != 0;
}

/// The other ranks, as the first sees them: worker k is rank k + 1.
class OtherRanks : public OutsideWorkers {
 public:
  explicit OtherRanks(int ranks) : count_(ranks - 1) {}

  std::size_t count() const override { return static_cast<std::size_t>(count_); }

  void start(std::size_t worker, std::size_t unit) override {
    MPI_Send(&unit, sizeof unit, MPI_BYTE, static_cast<int>(worker) + 1, order_tag, MPI_COMM_WORLD);
  }

  std::optional<Report> report() override {
    MPI_Status status;
    if (!waits_for_me(MPI_ANY_SOURCE, answer_tag, status)) return std::nullopt;
    const int rank = status.MPI_SOURCE;
    Report report{static_cast<std::size_t>(rank - 1), {}, {}};
    MPI_Recv(&report.answer, sizeof report.answer, MPI_BYTE, rank, answer_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    report.result.resize(report.answer.bytes);
    in_messages(report.result.data(), report.answer.bytes, [&](std::uint8_t* part, int bytes) {
      MPI_Recv(part, bytes, MPI_BYTE, rank, result_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    });
    return report;
  }

  /// Lets all of them go, once they are through with what they have. while_waiting ends it by what it throws: one that
  /// has died does not answer.
  void dismiss(const std::function<void()>& while_waiting) {
    for (std::size_t k = 0; k < count(); ++k) start(k, no_more);
    for (int gone = 0; gone < count_; usleep(interval)) {
      if (while_waiting) while_waiting();
      while (const auto last = report()) gone += last->answer.unit == no_more ? 1 : 0;
    }
  }

 private:
  int count_;
};

std::size_t next_order() {
  MPI_Status status;
  while (!waits_for_me(first_rank, order_tag, status)) usleep(interval);
  std::size_t unit = 0;
  MPI_Recv(&unit, sizeof unit, MPI_BYTE, first_rank, order_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return unit;
}

void send_answer(const Answer& answer) {
  MPI_Send(&answer, sizeof answer, MPI_BYTE, first_rank, answer_tag, MPI_COMM_WORLD);
}

/// What a rank but the first does of the work.
void work_for_first(const WorkInUnits& work) {
  DoUnit do_unit;
  for (std::size_t unit = next_order(); unit != no_more; unit = next_order()) {
    UnitResult result;
    Answer answer = answer_of(unit, [&] {
      if (!do_unit) do_unit = work.prepare();
      result = do_unit(unit);
    });
    answer.bytes = result.size();
    send_answer(answer);
    in_messages(result.data(), result.size(), [](const std::uint8_t* part, int bytes) {
      MPI_Send(part, bytes, MPI_BYTE, first_rank, result_tag, MPI_COMM_WORLD);
    });
  }
  send_answer({.unit = no_more});
}

/// Another rank has failed, and the first tells so.
struct ToldElsewhere {};

/// What a rank brings to a meeting of all.
struct Standing {
  Answer answer;
  std::size_t work = 0;  ///< a hash of what it is about to do
  char machine[MPI_MAX_PROCESSOR_NAME] = {};
};

}  // namespace

/// MPI, from its start to its end.
struct Ranks::Link {
  int rank = 0, ranks = 1;
  bool over = false;   ///< a meeting has found a failure: there is none after it
  bool apart = false;  ///< this rank goes without the others, whom what started them ends

  Link() {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  }
  ~Link() {
    if (!apart) MPI_Finalize();
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// All ranks come here: before work they share, and at their end, with their failure where there is one. Whether all
  /// are well then; otherwise the first throws the failure of the lowest rank that has one.
  void meet(const Answer& answer, const std::string& work) {
    Standing mine{.answer = answer, .work = std::hash<std::string>()(work)};
    int length = 0;
    MPI_Get_processor_name(mine.machine, &length);
    std::vector<Standing> all(static_cast<std::size_t>(ranks));
    MPI_Request request;
    MPI_Iallgather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, MPI_COMM_WORLD, &request);
    for (int met = 0; met == 0; usleep(interval)) MPI_Test(&request, &met, MPI_STATUS_IGNORE);
    const auto failed =
        std::find_if(all.begin(), all.end(), [](const Standing& one) { return one.answer.outcome != Outcome::done; });
    const auto other =
        std::find_if(all.begin(), all.end(), [&](const Standing& one) { return one.work != all.front().work; });
    over = failed != all.end() || other != all.end();
    if (!over) return;
    if (rank != first_rank) throw ToldElsewhere();
    if (failed == all.begin()) failed->answer.rethrow();
    const auto where = [&](auto who) { return fmt::format("rank {} on {}", who - all.begin(), who->machine); };
    if (failed != all.end()) {
      Answer told = failed->answer;
      const std::string words = where(failed) + ": " + failed->answer.words;
      std::strncpy(told.words, words.c_str(), Answer::longest_words);
      told.rethrow();
    }
    throw RunError(where(other) + " does not see the same run as the first; is it complete, and on a disk of both?");
  }
};

Ranks::Ranks() = default;
Ranks::~Ranks() = default;

bool Ranks::first() const { return !link_ || link_->rank == first_rank; }
int Ranks::count() const { return link_ ? link_->ranks : 1; }

void Ranks::do_units(const WorkInUnits& work, int workers) {
  if (!link_) return viz::do_units(work, workers);
  link_->meet({}, fmt::format("{} {} {} {}", work.count, work.unit_name, work.result_bytes, work.subject));
  omp_set_num_threads(1);
  setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe draws in this thread
  if (!first()) return work_for_first(work);
  OtherRanks others(link_->ranks);
  try {
    try {
      viz::do_units(work, 1, &others);
    } catch (const Interrupted&) {
      throw;
    } catch (...) {
      others.dismiss(work.while_waiting);
      throw;
    }
    others.dismiss(work.while_waiting);
  } catch (const Interrupted&) {
    link_->over = link_->apart = true;  // where a rank has died it would answer no more
    throw;
  }
}

void with_ranks(const std::function<void(Ranks&)>& work) {
  Ranks ranks;
  const auto process = launched();
  if (!process || process->ranks == 1) return work(ranks);
  ranks.link_ = std::make_unique<Ranks::Link>();
  if (ranks.link_->rank != process->rank || ranks.link_->ranks != process->ranks) {
    throw RunError(
        fmt::format("started as {} of {} processes, of which MPI finds {}; was it built for another MPI "
                    "than the one that starts it?",
                    process->rank + 1, process->ranks, ranks.link_->ranks));
  }
  try {
    const Answer answer = answer_of(0, [&] { work(ranks); });
    if (!ranks.link_->over) ranks.link_->meet(answer, "");
    answer.rethrow();
  } catch (const ToldElsewhere&) {
  }
}

}  // namespace packstone::viz
