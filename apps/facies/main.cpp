// SPDX-License-Identifier: Apache-2.0
// facies: the command line.
#include "apps/facies/commands.hpp"

int main(int argc, char** argv) {
  return facies::cli::run_program(argc, argv);
}
