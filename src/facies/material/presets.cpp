// SPDX-License-Identifier: Apache-2.0
// Published sets of parameters, each with its source and what is doubtful about it.
#include "facies/material/catalog.hpp"

namespace facies::material {

namespace {

/// Fung parameters with all diagonal lambda equal and all other lambda equal, as in every published set [kPa].
Parameters fung(double c, double mu1, double mu23, double lambda_diagonal, double lambda_other) {
  return {{"c", c},
          {"mu1", mu1},
          {"mu2", mu23},
          {"mu3", mu23},
          {"lambda11", lambda_diagonal},
          {"lambda22", lambda_diagonal},
          {"lambda33", lambda_diagonal},
          {"lambda12", lambda_other},
          {"lambda23", lambda_other},
          {"lambda31", lambda_other},
          {"kappa", 250.0}};
}

Parameters mooney_rivlin(double C10, double C20, double kappa) {
  return {{"C10", C10}, {"C01", 0.0}, {"C20", C20}, {"kappa", kappa}};
}

const char* const table1 = "Flynn et al. 2015, Table 1";
const char* const public_code = "artisynth_models, badinface demo";
const char* const doubtful_header =
    "The heading of Table 1 is damaged in the text at hand: its columns are read as c, mu1, mu2, "
    "mu3, "
    "lambda11 = lambda22 = lambda33, lambda12 = lambda23 = lambda31, kappa.";

std::vector<Preset> fung_skins() {
  return {
      {"flynn2015_normal", "fung_orthotropic", fung(21.3, 17.8, 5.9, 1.0, 1.0), table1,
       std::string(doubtful_header) +
           " The authors' public code agrees except for c, 3.784 kPa there: see artisynth_normal."},
      {"flynn2015_stiff", "fung_orthotropic", fung(42.6, 35.6, 11.8, 2.0, 2.0), table1,
       "Twice the normal skin. The text at hand prints lambda11 = lambda22 = lambda33 = 11.8, "
       "probably "
       "a slip from the column before; 2.0 follows from doubling and stands in the public code. "
       "See "
       "flynn2015_stiff_as_printed."},
      {"flynn2015_stiff_as_printed", "fung_orthotropic", fung(42.6, 35.6, 11.8, 11.8, 2.0), table1,
       "lambda11 = lambda22 = lambda33 = 11.8 as printed; probably 2.0 is meant: see "
       "flynn2015_stiff."},
      {"flynn2015_soft", "fung_orthotropic", fung(10.7, 8.9, 3.0, 0.5, 0.5), table1,
       "Half of the normal skin with the rounding of the table: 10.7 and 3.0 for 10.65 and 2.95."},
      {"artisynth_normal", "fung_orthotropic", fung(3.784, 17.773, 5.931, 1.0, 1.0), public_code,
       "c is 21.3 kPa in the paper: from a stretch of 1.15 on this skin is much stiffer."},
      {"artisynth_stiff", "fung_orthotropic", fung(7.568, 35.546, 11.862, 2.0, 2.0), public_code,
       "Commented out there as \"older\": twice artisynth_normal."},
      {"artisynth_soft", "fung_orthotropic", fung(1.892, 8.8865, 2.9655, 0.5, 0.5), public_code,
       "Commented out there as \"younger\": half of artisynth_normal."},
  };
}

std::vector<Preset> other_tissues() {
  return {
      {"nazari2010_skin", "mooney_rivlin", mooney_rivlin(2.5, 1.175, 250.0),
       "Nazari et al. 2010 in Flynn et al. 2015, Table 1",
       "kappa is unreadable in the text at hand (\"26\" over \"23\", then \"50.0\"): 250 fits both "
       "fragments. The public code has 25: see nazari2010_skin_kappa25."},
      {"nazari2010_skin_kappa25", "mooney_rivlin", mooney_rivlin(2.5, 1.175, 25.0), public_code,
       "kappa = 10 C10 as in the public code; nazari2010_skin has the paper's likely 250."},
      {"flynn2015_hypodermis", "mooney_rivlin", mooney_rivlin(0.4, 1.4, 50.0),
       "Flynn et al. 2015, Table 2, from Barbarino et al. 2011",
       "The table calls the third column D; it is read as kappa, as in Eq. 1 and the public code."},
      {"flynn2015_muscle",
       "fibre_blemker2005",
       {{"sigma_max", 100.0}, {"P1", 0.05}, {"P2", 6.6}, {"lambda_star", 1.4}},
       "Flynn et al. 2015, Table 4",
       "P1 has no unit in the table: at a stretch of 1.4 the passive stress is 0.65 kPa if P1 is "
       "in kPa "
       "and 65 kPa if it is in units of sigma_max. The public code's is nil."},
  };
}

std::vector<Preset> all_presets() {
  std::vector<Preset> all = fung_skins();
  for (Preset& preset : other_tissues())
    all.push_back(std::move(preset));
  return all;
}

}  // namespace

std::span<const Preset> presets() {
  static const std::vector<Preset> all = all_presets();
  return all;
}

}  // namespace facies::material
