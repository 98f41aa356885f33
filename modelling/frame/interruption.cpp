// SPDX-License-Identifier: LGPL-2.1-or-later
#include "modelling/frame/interruption.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <deque>
#include <unistd.h>

namespace rollfem::modelling {

namespace {

// A handler may only write prepared text: the last one. It may still be reading the one before.
std::deque<std::string> messages;
std::atomic<const char*> message{nullptr};

std::array<char*, 256> removed{};  // never freed: a handler may be reading it
std::atomic<std::size_t> removals{0};

void say_and_end(int signal) {
  const int before = errno;
  for (std::size_t k = 0, all = removals.load(); k < all; ++k)
    if (::unlink(removed[k]) != 0) ::rmdir(removed[k]);
  if (const char* text = message.load())
    if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) {
      // Nobody reads stderr any more.
    }
  errno = before;
  static_cast<void>(std::raise(signal));  // SA_RESETHAND has removed the handler
}

}  // namespace

void handle_interruptions() {
  struct sigaction end {};
  end.sa_handler = say_and_end;
  end.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      ::sigaction(signal, &end, nullptr);
  }
}

void remove_when_interrupted(const std::string& path) {
  const std::size_t count = removals.load();
  if (count == removed.size()) return;
  removed[count] = ::strdup(path.c_str());
  removals.store(removed[count] == nullptr ? count : count + 1);
}

void remove_nothing_when_interrupted() {
  removals.store(0);
}

void say_when_interrupted(const std::string& what) {
  if (what.empty()) {
    message.store(nullptr);
    return;
  }
  // On a terminal a progress line may be unfinished.
  const std::string begin = ::isatty(STDERR_FILENO) != 0 ? "\n" : "";
  messages.push_back(begin + "rollfem: interrupted: " + what + '\n');
  message.store(messages.back().c_str());
  if (messages.size() > 2) messages.pop_front();
}

}  // namespace rollfem::modelling
