#include "core/trial.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"

namespace packstone {

namespace {

constexpr rlim_t most_processor_time = 20;  ///< [s]
constexpr unsigned longest = 120;           ///< [s], on a busy machine or a slow disk
constexpr int no_memory = 1;                ///< exit code

std::size_t memory_in_use() {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0;
  file >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void limit(int what, rlim_t value) {
  const rlimit limits{value, value};
  setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

[[noreturn]] void try_here(std::size_t more_memory, const std::function<std::string()>& work, int to_parent) {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU}) std::signal(number, SIG_DFL);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, most_processor_time);
  limit(RLIMIT_AS, memory_in_use() + more_memory);
  alarm(longest);
  try {
    const std::string result = work();
    for (std::size_t sent = 0; sent < result.size();) {
      const ssize_t count = write(to_parent, result.data() + sent, result.size() - sent);
      if (count < 0) _exit(no_memory);
      sent += static_cast<std::size_t>(count);
    }
  } catch (const std::bad_alloc&) {
    _exit(no_memory);
  } catch (const std::length_error&) {
    _exit(no_memory);
  } catch (...) {
    // This process will meet it too, and tell it.
  }
  _exit(0);
}

std::string all_from(int source) {
  std::string all;
  char part[1 << 16];
  for (;;) {
    const ssize_t count = read(source, part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return all;
    all.append(part, static_cast<std::size_t>(count));
  }
}

std::string failure_of(int status) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return number == SIGALRM || number == SIGXCPU ? "reading it does not end" : "reading it crashes";
  }
  if (WEXITSTATUS(status) == no_memory) return "it asks for more memory than it could fill";
  return WEXITSTATUS(status) == 0 ? "" : "reading it crashes";
}

}  // namespace

Trial tried(std::size_t more_memory, const std::function<std::string()>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw RunError(std::string("a file cannot be tried: ") + std::strerror(errno));
  std::fflush(nullptr);  // or both processes write what is still there
  const pid_t child = fork();
  if (child == 0) try_here(more_memory, work, ends[1]);
  const int error = errno;
  close(ends[1]);
  Trial trial;
  if (child > 0) trial.result = all_from(ends[0]);
  close(ends[0]);
  if (child < 0) throw RunError(std::string("a file cannot be tried: ") + std::strerror(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  trial.failure = failure_of(status);
  return trial;
}

std::string failure_in_trial(std::size_t more_memory, const std::function<void()>& work) {
  const auto without_result = [&] {
    work();
    return std::string();
  };
  return tried(more_memory, without_result).failure;
}

}  // namespace packstone
