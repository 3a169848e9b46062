// SPDX-License-Identifier: Apache-2.0
// The life of the solver library in a process.
#pragma once

namespace facies::solve {

/// Starts PETSc (and MPI below it) and ends it with the last session. Anything else of this room needs one alive.
/// PETSc's own signal handlers and option files are left out: signals belong to the program.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  Session(Session&&) = delete;
  Session& operator=(Session&&) = delete;

 private:
  bool started_here_ = false;
};

/// "PETSc 3.18.5, MUMPS" for summaries.
[[nodiscard]] const char* solver_versions();

}  // namespace facies::solve
