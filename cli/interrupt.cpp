#include "cli/interrupt.hpp"

#include <csignal>

namespace packstone::cli {

namespace {

volatile std::sig_atomic_t flag = 0;

void note_signal(int number) {
  flag = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

bool interrupted() { return flag != 0; }

}  // namespace packstone::cli
