// SPDX-License-Identifier: Apache-2.0
// PETSc return codes as exceptions. Only sources of this room may include it.
#pragma once

#include <string>

#include <petscsys.h>

#include "facies/base/error.hpp"

namespace facies::solve {

/// Throws NumericsError naming `what` was attempted where `code` is not success.
inline void check(PetscErrorCode code, const char* what) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw NumericsError(std::string(what) + ": " +
                      (text != nullptr ? text : "PETSc error " + std::to_string(code)));
}

}  // namespace facies::solve
