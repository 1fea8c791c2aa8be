#include "runtime/driver/outcome.hpp"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Outcome, TellsTheGravestAsExitCode) {
  Outcome outcome;
  EXPECT_EQ(outcome.exit_code(), 0);
  outcome.unsettled = true;
  EXPECT_EQ(outcome.exit_code(), 3);
  outcome.script_failed = true;
  EXPECT_EQ(outcome.exit_code(), 1) << "an error in the script before a solve that did not settle";
  outcome.file_failed = true;
  EXPECT_EQ(outcome.exit_code(), 4) << "a file before an error in the script";
  outcome.wrong_usage = true;
  EXPECT_EQ(outcome.exit_code(), 2);
  outcome.interrupted = true;
  EXPECT_EQ(outcome.exit_code(), 130);
}

TEST(Outcome, OfSeveralCallsIsAllTheirTroubles) {
  Outcome first, second;
  first.unsettled = true;
  second.script_failed = true;
  first.add(second);
  EXPECT_TRUE(first.unsettled);
  EXPECT_EQ(first.exit_code(), 1);
}

}  // namespace
}  // namespace toile
