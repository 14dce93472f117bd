#include "brep/occt/trial_process.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace mesher::test {
namespace {

TEST(TrialProcess, TellsACrashFromAnEnd)
{
    EXPECT_TRUE(endsByItself([] {}));
    EXPECT_FALSE(endsByItself([] { std::raise(SIGSEGV); }));
    EXPECT_FALSE(endsByItself([] { std::raise(SIGABRT); }));
}

TEST(TrialProcess, AnExceptionIsNoCrash)
{
    EXPECT_TRUE(endsByItself([] { throw std::runtime_error("told again by the caller's own run"); }));
}

TEST(TrialProcess, WhatTheStepChangesIsNotSeenHere)
{
    int value = 1;
    EXPECT_TRUE(endsByItself([&] { value = 2; }));
    EXPECT_EQ(value, 1);
}

TEST(TrialProcess, AProcessThatStandsStillIsGivenUp)
{
    EXPECT_TRUE(endsByItself([] {
        for (;;) pause();
    }));
}

TEST(TrialProcess, HandlersOfTheCallerDoNotHideACrash)
{
    const auto previous = std::signal(SIGSEGV, [](int) { std::_Exit(0); });
    EXPECT_FALSE(endsByItself([] { std::raise(SIGSEGV); }));
    std::signal(SIGSEGV, previous);
}

}  // namespace
}  // namespace mesher::test
