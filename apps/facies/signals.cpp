// SPDX-License-Identifier: Apache-2.0
#include "apps/facies/signals.hpp"

#include <csignal>

namespace facies::cli {

namespace {

// A signal handler can reach nothing but a variable of static life.
volatile std::sig_atomic_t stop_requested = 0;

extern "C" void note_stop(int /*signal*/) {
  stop_requested = 1;
}

}  // namespace

void listen_for_stop() {
  struct sigaction action {};
  action.sa_handler = note_stop;
  action.sa_flags =
      static_cast<int>(SA_RESETHAND);  // the second signal does what it does by default
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool stop_was_requested() {
  return stop_requested != 0;
}

}  // namespace facies::cli
