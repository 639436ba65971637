// Ctrl-C (and a polite kill): ends the program at once while nothing can be lost, and otherwise asks it to stop.
// The one global of the program lives behind these four names, because a signal handler can reach nothing else.
#pragma once

namespace delone::cli {

/// From now on SIGINT, SIGTERM and SIGHUP end the program with exit code 128 + signal.
void handle_interrupts();

/// The signal that asked the program to stop, or 0.
int interrupted();

/// While one lives, the first signal only makes interrupted() answer; a second one ends the program.
class DeferInterrupt {
 public:
  DeferInterrupt();
  ~DeferInterrupt();
  DeferInterrupt(const DeferInterrupt&) = delete;
  DeferInterrupt& operator=(const DeferInterrupt&) = delete;
};

}  // namespace delone::cli
