// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/factor.hpp"

#include <algorithm>

#include <petscmat.h>

#include "facies/solve/petsc_check.hpp"

namespace facies::solve {

namespace {

/// Extra workspace for delayed pivots [percent of what the analysis expects]: what MUMPS gets at first, and at most.
constexpr PetscInt first_workspace = 40;
constexpr PetscInt largest_workspace = 40 * 64;

}  // namespace

struct SymmetricFactor::Petsc {
  std::vector<PetscInt> row_begin, column;
  std::vector<PetscScalar> values;
  Mat matrix = nullptr;
  Mat factor = nullptr;
  Vec rhs = nullptr;
  Vec solution = nullptr;
  PetscInt workspace = first_workspace;

  Petsc() = default;
  Petsc(const Petsc&) = delete;
  Petsc& operator=(const Petsc&) = delete;
  Petsc(Petsc&&) = delete;
  Petsc& operator=(Petsc&&) = delete;
  ~Petsc() {
    VecDestroy(&solution);
    VecDestroy(&rhs);
    MatDestroy(&factor);
    MatDestroy(&matrix);
  }
};

/// A factor that knows the pattern (symbolic phase) and waits for values.
void SymmetricFactor::analyse() {
  Petsc& p = *petsc_;
  check(MatGetFactor(p.matrix, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, &p.factor), "choosing MUMPS");
  check(MatMumpsSetIcntl(p.factor, 7, 5), "ordering by METIS");
  check(MatMumpsSetIcntl(p.factor, 8, 0), "leaving the matrix unscaled");
  check(MatMumpsSetIcntl(p.factor, 13, 1), "asking MUMPS for the inertia");
  check(MatMumpsSetIcntl(p.factor, 14, p.workspace), "giving MUMPS workspace");
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info), "preparing the analysis");
  check(MatCholeskyFactorSymbolic(p.factor, p.matrix, nullptr, &info),
        "analysing the stiffness matrix");
}

SymmetricFactor::SymmetricFactor(const SparsityPattern& pattern)
    : petsc_(std::make_unique<Petsc>()) {
  Petsc& p = *petsc_;
  p.row_begin.assign(pattern.row_begin.begin(), pattern.row_begin.end());
  p.column.assign(pattern.column.begin(), pattern.column.end());
  p.values.assign(pattern.n_nonzeros(), 0.0);
  const auto n = static_cast<PetscInt>(pattern.size());
  check(MatCreateSeqSBAIJWithArrays(PETSC_COMM_SELF, 1, n, n, p.row_begin.data(), p.column.data(),
                                    p.values.data(), &p.matrix),
        "creating the stiffness matrix");
  check(MatCreateVecs(p.matrix, &p.solution, &p.rhs), "creating vectors");
}

SymmetricFactor::~SymmetricFactor() = default;

int SymmetricFactor::factorise(std::span<const double> values) {
  if (values.empty()) return 0;
  Petsc& p = *petsc_;
  std::copy(values.begin(), values.end(), p.values.begin());
  MatFactorInfo info;
  check(MatFactorInfoInitialize(&info), "preparing the factorisation");
  while (true) {
    if (p.factor == nullptr) analyse();
    check(MatCholeskyFactorNumeric(p.factor, p.matrix, &info), "factorising the stiffness matrix");
    MatFactorError error = MAT_FACTOR_NOERROR;
    check(MatFactorGetError(p.factor, &error), "asking how the factorisation ended");
    if (error == MAT_FACTOR_NOERROR) break;
    // After an error MUMPS refuses all further work with this factor, whatever the values: begin anew.
    check(MatDestroy(&p.factor), "giving a factor up");
    const bool singular =
        error == MAT_FACTOR_NUMERIC_ZEROPIVOT || error == MAT_FACTOR_STRUCT_ZEROPIVOT;
    if (singular) return static_cast<int>(p.row_begin.size()) - 1;
    if (p.workspace >= largest_workspace)
      throw NumericsError("factorising the stiffness matrix: not enough memory");
    p.workspace *= 4;
  }
  PetscInt negative = 0;
  check(MatGetInertia(p.factor, &negative, nullptr, nullptr), "asking MUMPS for the inertia");
  return static_cast<int>(negative);
}

void SymmetricFactor::solve(std::span<const double> rhs, std::span<double> x) const {
  if (rhs.empty()) return;
  const Petsc& p = *petsc_;
  require(p.factor != nullptr, "solving needs a factorisation that went well");
  check(VecPlaceArray(p.rhs, rhs.data()), "handing over a right-hand side");
  check(VecPlaceArray(p.solution, x.data()), "handing over a solution");
  const PetscErrorCode code = MatSolve(p.factor, p.rhs, p.solution);
  VecResetArray(p.rhs);
  VecResetArray(p.solution);
  check(code, "solving with the factorised stiffness matrix");
}

double SymmetricFactor::factor_nonzeros() const {
  require(petsc_->factor != nullptr, "there is no factorisation yet");
  MatInfo info;
  check(MatGetInfo(petsc_->factor, MAT_LOCAL, &info), "asking for the size of the factor");
  return info.nz_used;
}

}  // namespace facies::solve
