// SPDX-License-Identifier: Apache-2.0
// facies schema: what a scenario file may say, for editors and for people.
#include <iostream>
#include <memory>

#include "apps/facies/commands.hpp"
#include "apps/facies/errors.hpp"
#include <CLI/CLI.hpp>

#include "facies/scenario/describe_schema.hpp"

namespace facies::cli {

void add_schema(CLI::App& app, Action& action) {
  CLI::App* sub =
      app.add_subcommand("schema",
                         "Print the JSON Schema (draft-07) of scenario files, for editors.\n\n"
                         "Examples:\n"
                         "  facies schema > facies.schema.json\n"
                         "  facies schema --markdown > docs/scenario-reference.md\n");
  auto markdown = std::make_shared<bool>(false);
  sub->add_flag("--markdown", *markdown, "print the reference page instead");
  sub->callback([markdown, &action] {
    action = [markdown] {
      std::cout << (*markdown ? scenario::reference_page() : scenario::json_schema());
      return exit_status::done;
    };
  });
}

}  // namespace facies::cli
