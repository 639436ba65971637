#include "interrupt.hpp"

#include <signal.h>
#include <unistd.h>

#include <initializer_list>

namespace delone::cli {
namespace {

volatile sig_atomic_t asked = 0;     // the signal that arrived
volatile sig_atomic_t deferred = 0;  // how many DeferInterrupt live

extern "C" void on_signal(int signal) {
  if (deferred != 0 && asked == 0) {
    asked = signal;
    return;
  }
  constexpr char kMessage[] = "\ndelone: interrupted\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kMessage, sizeof kMessage - 1);
  _exit(128 + signal);
}

}  // namespace

void handle_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;  // as nohup wants it
    struct sigaction action {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
  }
}

int interrupted() { return asked; }

DeferInterrupt::DeferInterrupt() { deferred = deferred + 1; }
DeferInterrupt::~DeferInterrupt() { deferred = deferred - 1; }

}  // namespace delone::cli
