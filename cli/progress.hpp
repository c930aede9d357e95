// Progress on stderr: one line that updates on a terminal, plain lines now and then elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace packstone::cli {

class Progress {
 public:
  /// what: the work in a word or two, such as "frames".
  Progress(std::string what, bool quiet);
  ~Progress();

  /// done out of total; note: further text, such as the physical time.
  void update(std::int64_t done, std::int64_t total, const std::string& note = "");

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace packstone::cli
