// SPDX-License-Identifier: Apache-2.0
// Fung-type orthotropic skin, flynn2015 Eqs. 2-3 (ateshian2009), distortional part:
//
//   psi = c/2 (exp(Q) - 1)
//   Q   = 1/c sum_a [ 2 mu_a A_a : E_bar^2 + sum_b lambda_ab (A_a : E_bar)(A_b : E_bar) ],   A_a = a_a (x) a_a
//   E_bar = (C_bar - I) / 2
//
//   code       paper       unit  meaning
//   c          c           kPa   scale of the energy: the smaller, the sooner the skin stiffens
//   mu1..mu3   mu_a        kPa   shear moduli of the material axes a1, a2, a3
//   lambda11.. lambda_ab   kPa   coupling moduli, lambda_ab = lambda_ba
//   E_bar      E~          -     distortional Green-Lagrange strain
//   axes       a_a^0       -     a1 along the skin line, a2 the outer normal, a3 = a1 x a2 (columns)
//
// Closed form. c Q is a constant quadratic form e.D e of the strain vector e, so
//   S_bar = exp(Q) D e,   C4_bar = exp(Q) (D + 2/c D e (x) D e).
//
// Validity     fitted to stretches of forearm skin up to about 1.3; exp(Q) grows without bound and overflows to
//              infinity near Q = 710: the answer is then not finite, and a solver must refuse the trial state.
//              Positive definite energy needs D > 0, i.e. the 3x3 block 2 mu_a delta_ab + lambda_ab > 0 (checked).
// Departures   none; the paper's kappa/2 (ln J)^2 is volumetric_log.
// Parameters   flynn2015 Table 1 (fit to the forearm skin of flynn2011): see presets.cpp.
#include <cmath>

#include <Eigen/Cholesky>

#include "facies/material/catalog.hpp"

namespace facies::material {

namespace {

/// Moduli of Eq. 3 [kPa].
struct Moduli {
  double c = 0.0;
  Vec3 mu = Vec3::Zero();
  Mat3 lambda = Mat3::Zero();
};

Moduli moduli(const Parameters& values) {
  Moduli m;
  m.c = values.at("c");
  m.mu << values.at("mu1"), values.at("mu2"), values.at("mu3");
  m.lambda.diagonal() << values.at("lambda11"), values.at("lambda22"), values.at("lambda33");
  m.lambda(0, 1) = m.lambda(1, 0) = values.at("lambda12");
  m.lambda(1, 2) = m.lambda(2, 1) = values.at("lambda23");
  m.lambda(2, 0) = m.lambda(0, 2) = values.at("lambda31");
  return m;
}

/// The block of D that meets the normal strains along the axes.
Mat3 normal_block(const Moduli& m) {
  Mat3 block = m.lambda;
  block.diagonal() += 2.0 * m.mu;
  return block;
}

/// D in the frame of `axes`: c Q = e.D e.
Mat6 quadratic_form(const Moduli& m, const Mat3& axes) {
  Mat6 D = Mat6::Zero();
  D.topLeftCorner<3, 3>() = normal_block(m);
  D(3, 3) = 0.5 * (m.mu(0) + m.mu(1));
  D(4, 4) = 0.5 * (m.mu(1) + m.mu(2));
  D(5, 5) = 0.5 * (m.mu(2) + m.mu(0));
  const Mat6 to_axes = strain_rotation(axes);
  return to_axes.transpose() * D * to_axes;
}

class FungOrthotropic final : public Law {
 public:
  FungOrthotropic(const Moduli& m, const Mat3& axes)
      : m_(m), axes_(axes), D_(quadratic_form(m, axes)) {}

  [[nodiscard]] double energy(const Sym3<double>& C_bar) const override { return psi(C_bar); }
  [[nodiscard]] Dual2<6> energy(const Sym3<Dual2<6>>& C_bar) const override { return psi(C_bar); }

  [[nodiscard]] LawResponse respond(const Sym3<double>& C_bar) const override {
    const StrainVoigt e = 0.5 * (strain_voigt(C_bar) - identity_voigt());
    const StressVoigt De = D_ * e;
    const double Q = e.dot(De) / m_.c;
    const double exp_Q = std::exp(Q);
    LawResponse response;
    response.psi = 0.5 * m_.c * std::expm1(Q);
    response.S_bar = exp_Q * De;
    response.C4_bar = exp_Q * D_ + (2.0 * exp_Q / m_.c * De) * De.transpose();
    return response;
  }

  [[nodiscard]] StressVoigt stress(const Sym3<double>& C_bar) const override {
    const StrainVoigt e = 0.5 * (strain_voigt(C_bar) - identity_voigt());
    const StressVoigt De = D_ * e;
    return std::exp(e.dot(De) / m_.c) * De;
  }

 private:
  /// Eq. 2-3 as printed: with e_ab = a_a . E_bar a_b, A_a : E_bar^2 is the sum of e_ab^2 over b.
  template <class T>
  [[nodiscard]] T psi(const Sym3<T>& C_bar) const {
    using std::expm1;
    T c_Q{0.0};
    std::array<T, 3> normal{};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        const Sym3<double> A_ab = to_sym3(axes_.col(a) * axes_.col(b).transpose());
        const T e_ab = 0.5 * (double_dot(C_bar, A_ab) - trace(A_ab));
        c_Q += 2.0 * m_.mu(a) * e_ab * e_ab;
        if (a == b) normal[static_cast<std::size_t>(a)] = e_ab;
      }
    }
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        c_Q += m_.lambda(a, b) * normal[static_cast<std::size_t>(a)] *
               normal[static_cast<std::size_t>(b)];
      }
    }
    return 0.5 * m_.c * expm1(c_Q / m_.c);
  }

  Moduli m_;
  Mat3 axes_;
  Mat6 D_;
};

std::vector<Problem> check(const Parameters& values) {
  if (Eigen::LLT<Mat3>(normal_block(moduli(values))).info() == Eigen::Success) return {};
  return {{"/lambda12, /lambda23, /lambda31",
           "too large beside mu and lambda11, lambda22, lambda33: some strain would give energy",
           "a positive definite matrix 2 mu_a delta_ab + lambda_ab",
           "lower lambda12, lambda23 or lambda31"}};
}

ParamSpec modulus(const char* name, const char* meaning, bool positive) {
  ParamSpec spec;
  spec.name = name;
  spec.unit = "kPa";
  spec.meaning = meaning;
  spec.exclusive_minimum = positive;
  return spec;
}

}  // namespace

LawSpec fung_orthotropic() {
  LawSpec spec;
  spec.name = "fung_orthotropic";
  spec.summary = "orthotropic skin that stiffens exponentially, strongest along the skin lines";
  spec.source = "Flynn et al. 2015, Eqs. 2-3; Ateshian and Costa 2009";
  spec.has_axes = true;
  spec.parameters = {
      modulus("c", "scale of the energy; the smaller, the sooner the skin stiffens", true),
      modulus("mu1", "shear modulus of axis 1, along the skin line", true),
      modulus("mu2", "shear modulus of axis 2, the outer normal", true),
      modulus("mu3", "shear modulus of axis 3, across the skin line", true),
      modulus("lambda11", "coupling modulus of axis 1", false),
      modulus("lambda22", "coupling modulus of axis 2", false),
      modulus("lambda33", "coupling modulus of axis 3", false),
      modulus("lambda12", "coupling modulus between axes 1 and 2", false),
      modulus("lambda23", "coupling modulus between axes 2 and 3", false),
      modulus("lambda31", "coupling modulus between axes 3 and 1", false),
  };
  spec.example = {{"c", 21.3},       {"mu1", 17.8},     {"mu2", 5.9},      {"mu3", 4.1},
                  {"lambda11", 1.0}, {"lambda22", 0.8}, {"lambda33", 1.2}, {"lambda12", 0.7},
                  {"lambda23", 0.9}, {"lambda31", 1.1}};
  spec.check = check;
  spec.make = [](const Parameters& values, const Mat3& axes) {
    return std::make_unique<const FungOrthotropic>(moduli(values), axes);
  };
  return spec;
}

}  // namespace facies::material
