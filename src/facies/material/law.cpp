// SPDX-License-Identifier: Apache-2.0
#include "facies/material/law.hpp"

namespace facies::material {

LawResponse Law::respond(const Sym3<double>& C_bar) const {
  return differentiate(*this, C_bar);
}

StressVoigt Law::stress(const Sym3<double>& C_bar) const {
  return respond(C_bar).S_bar;
}

LawResponse differentiate(const Law& law, const Sym3<double>& C_bar) {
  using Dual = Dual2<6>;
  const Dual psi = law.energy(Sym3<Dual>{Dual::variable(C_bar.xx, 0), Dual::variable(C_bar.yy, 1),
                                         Dual::variable(C_bar.zz, 2), Dual::variable(C_bar.xy, 3),
                                         Dual::variable(C_bar.yz, 4), Dual::variable(C_bar.xz, 5)});
  LawResponse response;
  response.psi = psi.value;
  response.S_bar = 2.0 * tensor_gradient(psi.gradient);
  response.C4_bar = 4.0 * tensor_hessian(psi.hessian);
  return response;
}

}  // namespace facies::material
