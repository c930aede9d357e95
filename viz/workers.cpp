#include "viz/workers.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <omp.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"

namespace packstone::viz {

namespace {

constexpr int most_deaths = 3;          ///< of workers on one unit
constexpr std::size_t units_ahead = 2;  ///< a worker, of the first that is not taken yet: bounds the memory
constexpr int outside_interval = 1;     ///< to ask workers outside for their answers [ms]

bool send_all(int socket, const void* bytes, std::size_t count) {
  const auto* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = send(socket, next, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    next += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// False at the end of the other side.
bool receive_all(int socket, void* bytes, std::size_t count) {
  auto* next = static_cast<char*>(bytes);
  while (count > 0) {
    const ssize_t got = recv(socket, next, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    next += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

/// Memory that a process and those forked from it share.
class SharedMemory {
 public:
  explicit SharedMemory(std::size_t bytes) : bytes_(std::max<std::size_t>(bytes, 1)) {
    void* const memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
      throw RunError(fmt::format("no {} bytes of memory for a picture: {}", bytes_, std::strerror(errno)));
    memory_ = static_cast<std::uint8_t*>(memory);
  }
  ~SharedMemory() { munmap(memory_, bytes_); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  std::uint8_t* data() const { return memory_; }

 private:
  std::size_t bytes_;
  std::uint8_t* memory_;
};

/// A worker's life, until its parent's end of the socket closes. Results go through the shared memory where they fit.
void work_on(const WorkInUnits& work, int socket, std::uint8_t* shared) {
  DoUnit do_unit;
  std::size_t unit = 0;
  while (receive_all(socket, &unit, sizeof unit)) {
    UnitResult result;
    Answer answer = answer_of(unit, [&] {
      if (!do_unit) do_unit = work.prepare();
      result = do_unit(unit);
    });
    answer.bytes = result.size();
    const bool fits = result.size() <= work.result_bytes;
    if (fits) std::copy(result.begin(), result.end(), shared);
    if (!send_all(socket, &answer, sizeof answer)) return;
    if (!fits && !send_all(socket, result.data(), result.size())) return;
  }
}

/// A process that does units.
class Worker {
 public:
  Worker(const WorkInUnits& work, const std::vector<std::unique_ptr<Worker>>& others)
      : shared_bytes_(work.result_bytes), shared_(work.result_bytes) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail_to_start();
    std::fflush(nullptr);  // or both processes write what is still there
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0) {
      close(ends[0]);
      close(ends[1]);
      fail_to_start();
    }
    if (process_ == 0) {
      close(ends[0]);
      for (const auto& other : others) {
        if (other) close(other->socket_);  // or it would not see its parent go
      }
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != parent) _exit(EXIT_FAILURE);
      std::signal(SIGINT, SIG_IGN);  // the parent ends its workers
      omp_set_num_threads(1);
      setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe draws in this thread
      work_on(work, ends[1], shared_.data());
      _exit(EXIT_SUCCESS);
    }
    close(ends[1]);
    socket_ = ends[0];
  }
  ~Worker() {
    close(socket_);
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  int socket() const { return socket_; }
  bool idle() const { return !busy_; }
  std::size_t unit() const { return unit_; }

  /// False where the process is gone.
  bool start(std::size_t unit) {
    unit_ = unit;
    busy_ = true;
    return send_all(socket_, &unit, sizeof unit);
  }
  bool finish(Answer& answer, UnitResult& result) {
    busy_ = false;
    if (!receive_all(socket_, &answer, sizeof answer)) return false;
    if (answer.bytes <= shared_bytes_) {
      result.assign(shared_.data(), shared_.data() + answer.bytes);
      return true;
    }
    result.resize(answer.bytes);
    return receive_all(socket_, result.data(), result.size());
  }

 private:
  [[noreturn]] static void fail_to_start() {
    throw RunError(fmt::format("a worker process cannot be started: {}", std::strerror(errno)));
  }

  std::size_t shared_bytes_;
  SharedMemory shared_;
  pid_t process_ = 0;
  int socket_ = -1;
  bool busy_ = false;
  std::size_t unit_ = 0;
};

/// Hands out units and takes results, in this process.
class Foreman {
 public:
  Foreman(const WorkInUnits& work, std::size_t workers, OutsideWorkers* outside)
      : work_(work),
        workers_(workers),
        outside_(outside),
        idle_outside_(outside != nullptr ? outside->count() : 0, true),
        deaths_(work.count, 0) {
    for (std::size_t unit = 0; unit < work.count; ++unit) waiting_.push_back(unit);
  }

  void run() {
    while (taken_ < work_.count) {
      if (work_.while_waiting) work_.while_waiting();
      for (auto& worker : workers_) hand_out(worker);
      hand_outside();
      std::vector<pollfd> sockets;
      for (const auto& worker : workers_) {
        sockets.push_back({worker && !worker->idle() ? worker->socket() : -1, POLLIN, 0});
      }
      const int patience = idle_outside_.empty() ? -1 : outside_interval;
      if (poll(sockets.data(), sockets.size(), patience) < 0) continue;  // a signal: somebody may want to know
      for (std::size_t k = 0; k < sockets.size(); ++k) {
        if (sockets[k].revents != 0) collect(workers_[k]);
      }
      collect_outside();
      take_in_order();
    }
  }

 private:
  bool unit_to_hand_out() const {
    return !waiting_.empty() && waiting_.front() < taken_ + units_ahead * (workers_.size() + idle_outside_.size());
  }

  void hand_outside() {
    for (std::size_t k = 0; k < idle_outside_.size() && unit_to_hand_out(); ++k) {
      if (!idle_outside_[k]) continue;
      outside_->start(k, waiting_.front());
      waiting_.pop_front();
      idle_outside_[k] = false;
    }
  }

  void collect_outside() {
    if (idle_outside_.empty()) return;
    while (auto report = outside_->report()) {
      report->answer.rethrow();
      idle_outside_[report->worker] = true;
      results_[report->answer.unit] = std::move(report->result);
    }
  }

  void hand_out(std::unique_ptr<Worker>& worker) {
    if (!unit_to_hand_out() || (worker && !worker->idle())) return;
    if (!worker) worker = std::make_unique<Worker>(work_, workers_);
    const std::size_t unit = waiting_.front();
    waiting_.pop_front();
    if (!worker->start(unit)) bury(worker);
  }

  void collect(std::unique_ptr<Worker>& worker) {
    Answer answer;
    UnitResult result;
    if (!worker->finish(answer, result)) return bury(worker);
    answer.rethrow();
    results_[answer.unit] = std::move(result);
  }

  /// Its unit is the next to be done.
  void bury(std::unique_ptr<Worker>& worker) {
    const std::size_t unit = worker->unit();
    worker.reset();
    if (++deaths_[unit] == most_deaths) {
      throw RunError(fmt::format("{} {}: {} worker processes died on it; is there enough memory?", work_.unit_name,
                                 unit, most_deaths));
    }
    waiting_.push_front(unit);
  }

  void take_in_order() {
    for (auto next = results_.find(taken_); next != results_.end(); next = results_.find(taken_)) {
      work_.take(taken_, std::move(next->second));
      results_.erase(next);
      ++taken_;
    }
  }

  const WorkInUnits& work_;
  std::vector<std::unique_ptr<Worker>> workers_;
  OutsideWorkers* outside_;
  std::vector<bool> idle_outside_;
  std::deque<std::size_t> waiting_;
  std::map<std::size_t, UnitResult> results_;
  std::size_t taken_ = 0;
  std::vector<int> deaths_;
};

void do_alone(const WorkInUnits& work) {
  const DoUnit do_unit = work.prepare();
  for (std::size_t unit = 0; unit < work.count; ++unit) work.take(unit, do_unit(unit));
}

}  // namespace

void do_units(const WorkInUnits& work, int workers, OutsideWorkers* outside) {
  if (work.count == 0) return;
  const std::size_t needed = std::min(work.count, static_cast<std::size_t>(std::max(1, workers)));
  if (work.count == 1 || (needed == 1 && outside == nullptr)) return do_alone(work);
  Foreman(work, needed, outside).run();
}

}  // namespace packstone::viz
