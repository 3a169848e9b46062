# SPDX-License-Identifier: Apache-2.0
# Every library that facies uses, and nothing else. All of them are Debian 12 packages (tools/packages.txt).
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(CLI11 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(embree 3 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(PETSC REQUIRED IMPORTED_TARGET PETSc)
set(MPI_CXX_SKIP_MPICXX TRUE)
find_package(MPI REQUIRED COMPONENTS CXX)  # the headers of PETSc need those of MPI
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(LBFGS REQUIRED IMPORTED_TARGET liblbfgs)
find_package(OpenMP COMPONENTS CXX)  # without it the loops run on one thread, with the same bits

if(FACIES_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()
