#include "cli/progress.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "core/launched.hpp"

namespace packstone::cli {

namespace {

constexpr double terminal_interval = 0.2;  ///< [s]
constexpr double plain_interval = 10;      ///< [s]

std::string clock_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds + 0.5);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(std::string what, bool quiet)
    : what_(std::move(what)), quiet_(quiet || !speaks_for_all()), terminal_(isatty(2)) {}

Progress::~Progress() {
  if (line_open_) std::fputc('\n', stderr);
}

void Progress::update(std::int64_t done, std::int64_t total, const std::string& note) {
  if (quiet_) return;
  const auto now = Clock::now();
  const double waited = std::chrono::duration<double>(now - shown_).count();
  if (done < total && waited < (terminal_ ? terminal_interval : plain_interval)) return;
  shown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = done > 0 ? elapsed * static_cast<double>(total - done) / static_cast<double>(done) : 0;
  const std::string line = fmt::format(
      "{} {}/{} ({:.0f} %){}{}, {}", what_, done, total,
      total > 0 ? 100.0 * static_cast<double>(done) / static_cast<double>(total) : 100.0, note.empty() ? "" : ", ",
      note, done < total ? clock_text(left) + " left" : fmt::format("took {:.1f} s", elapsed));
  constexpr const char* clear_line = "\r\033[K";
  fmt::print(stderr, "{}{}{}", terminal_ ? clear_line : "", line, terminal_ ? "" : "\n");
  std::fflush(stderr);
  line_open_ = terminal_;
}

}  // namespace packstone::cli
