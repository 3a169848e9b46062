// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/session.hpp"

#include <cstdlib>
#include <dlfcn.h>

#include "facies/solve/petsc_check.hpp"

namespace facies::solve {

namespace {

#define FACIES_TEXT(x) #x
#define FACIES_VERSION_TEXT(major, minor, patch) \
  "PETSc " FACIES_TEXT(major) "." FACIES_TEXT(minor) "." FACIES_TEXT(patch) ", MUMPS"

/// The dense blocks of a face's factor are too small for several threads of OpenBLAS: they wait for each other, on a busy
/// machine ten times longer than they work. Any other BLAS is left as it is.
void keep_blas_on_one_thread() {
  using SetThreads = void (*)(int);
  const auto set_threads =
      reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  if (set_threads != nullptr) set_threads(1);
}

}  // namespace

Session::Session() {
  PetscBool initialised = PETSC_FALSE;
  PetscInitialized(&initialised);
  if (initialised == PETSC_TRUE) return;
  // One process alone needs no network transport; asking for none starts MPI faster and works without one.
  setenv("OMPI_MCA_btl", "self,vader", 0);
  setenv("OMPI_MCA_plm_rsh_agent", "", 0);
  setenv("OMPI_MCA_opal_signal", "", 0);
  // In a container without /sys its search for processors would complain on standard error.
  setenv("HWLOC_HIDE_ERRORS", "2", 0);
  PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
  check(PetscInitialize(nullptr, nullptr, nullptr, nullptr), "starting PETSc");
  check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr),
        "installing the error handler of PETSc");
  keep_blas_on_one_thread();
  started_here_ = true;
}

Session::~Session() {
  if (started_here_) PetscFinalize();
}

const char* solver_versions() {
  return FACIES_VERSION_TEXT(PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR);
}

}  // namespace facies::solve
