#include "cases/program/run/signals.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

TEST(ReliableSignals, AskTheRun) {
  Requests requests;
  const SignalGuard guard(requests);
  std::raise(SIGUSR1);
  EXPECT_TRUE(requests.save && requests.attention);
  EXPECT_FALSE(requests.stop);
  requests.attention = false;
  std::raise(SIGTERM);
  EXPECT_TRUE(requests.stop && requests.attention);
}

TEST(ReliableSignals, ASecondOneStopsAtOnce) {
  const auto twice = [](int first, int second) {
    Requests requests;
    const SignalGuard guard(requests);
    std::raise(first);
    std::raise(second);
  };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    EXPECT_EXIT(twice(SIGINT, signal), testing::KilledBySignal(signal), "");
}

TEST(ReliableSignals, WhatWasIgnoredStaysIgnored) {
  const auto before = std::signal(SIGHUP, SIG_IGN);
  Requests requests;
  {
    const SignalGuard guard(requests);
    std::raise(SIGHUP);
    EXPECT_FALSE(requests.stop);
  }
  EXPECT_EQ(std::signal(SIGHUP, before), SIG_IGN);
}

/// A reader that has gone and a limit on files make calls fail, not the program.
TEST(ReliableSignals, SomeKillNoMore) {
  Requests requests;
  const SignalGuard guard(requests);
  std::raise(SIGPIPE);
  std::raise(SIGXFSZ);
  EXPECT_FALSE(requests.stop);
}

}  // namespace
}  // namespace furnas
