// SPDX-License-Identifier: Apache-2.0
// Keeps the solver library alive while the tests of a program run. Including it is enough.
#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "facies/solve/session.hpp"

namespace facies::support {

class SolverSession final : public ::testing::Environment {
 public:
  void SetUp() override { session_ = std::make_unique<solve::Session>(); }
  void TearDown() override { session_.reset(); }

 private:
  std::unique_ptr<solve::Session> session_;
};

/// GoogleTest owns the environment.
inline ::testing::Environment* const solver_session =
    ::testing::AddGlobalTestEnvironment(new SolverSession);

}  // namespace facies::support
