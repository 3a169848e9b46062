// SPDX-License-Identifier: Apache-2.0
// facies study: variants of scenarios, one run after the other, one table.
#include <iostream>
#include <map>
#include <memory>

#include "apps/facies/commands.hpp"
#include "apps/facies/console_observer.hpp"
#include "apps/facies/errors.hpp"
#include "apps/facies/signals.hpp"
#include "apps/facies/version.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "facies/anatomy/sources.hpp"
#include "facies/base/files.hpp"
#include "facies/results/folder.hpp"
#include "facies/results/study_table.hpp"
#include "facies/scenario/build_model.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/run.hpp"
#include "facies/scenario/study.hpp"
#include "facies/solve/session.hpp"

namespace facies::cli {

namespace {

namespace fs = std::filesystem;

struct StudyCommand {
  std::string study;
  std::optional<std::string> face;
  std::string out;
  bool force = false;
  bool pictures = false;
  int threads = 0;
};

/// What the scenario names and the face does not have.
std::vector<Problem> problems_on(const anatomy::FaceAnatomy& face,
                                 const scenario::Scenario& scenario) {
  try {
    return scenario::check_against_face(
        scenario, scenario::names_on_face(face, scenario::choose_muscles(face, scenario)));
  } catch (const ScenarioError& error) {
    return error.problems();
  }
}

/// Reads the study and tries its scenarios on their faces. Throws with everything that is wrong before anything is
/// calculated. `is_paper_face` says of every run whether the paper's numbers are about its face.
scenario::Study read_checked(const StudyCommand& command, std::vector<bool>& is_paper_face) {
  const fs::path home = scenario::home_folder();
  scenario::StudyReading reading =
      scenario::read_study_reporting(scenario::find_study(command.study, home), home, command.face);
  if (!reading.problems.empty()) throw ScenarioError(std::move(reading.problems));
  is_paper_face.reserve(reading.study.runs.size());
  std::map<std::string, anatomy::FaceAnatomy> faces;
  std::map<std::string, Problem> problems;  // by their texts: variants share scenarios
  for (scenario::StudyRun& run : reading.study.runs) {
    run.scenario.output.pictures = run.scenario.output.pictures && command.pictures;
    const std::string& name = run.scenario.face;
    if (!faces.contains(name))
      faces.emplace(name, anatomy::load_face(name, scenario::data_folder()));
    const anatomy::FaceAnatomy& face = faces.at(name);
    is_paper_face.push_back(face.is_reference_face);
    for (const Problem& problem : problems_on(face, run.scenario))
      problems.emplace(to_string(problem), problem);
  }
  std::vector<Problem> all;
  all.reserve(problems.size());
  for (const auto& [text, problem] : problems)
    all.push_back(problem);
  if (!all.empty()) throw ScenarioError(std::move(all));
  return std::move(reading.study);
}

scenario::RunOptions options_of(const StudyCommand& command, const scenario::StudyRun& run) {
  scenario::RunOptions options;
  options.out = fs::path(command.out) / run.variant / run.scenario.name;
  options.data = scenario::data_folder();
  options.version = version();
  options.force = true;  // what is there is from an earlier state of the study
  options.pictures = run.scenario.output.pictures;
  options.threads = command.threads;
  return options;
}

/// Carries a run out, where that has not been done before, and tells on one line how it went.
void carry_out(const scenario::StudyRun& run, const scenario::RunOptions& options, bool again,
               const std::string& label) {
  if (!again && scenario::is_finished(run.scenario, options)) {
    std::cerr << label << "finished before\n";
    return;
  }
  const Terminal terminal = error_terminal();
  ConsoleObserver observer(std::cerr, terminal,
                           terminal.interactive ? Verbosity::normal : Verbosity::quiet);
  std::error_code failure;  // is told when the folder in it cannot be made
  fs::create_directory(options.out.parent_path(), failure);
  try {
    const scenario::RunSummary summary = scenario::run(run.scenario, options, observer);
    observer.clear();
    std::cerr << label
              << fmt::format("{} after {:.1f} s\n", summary.converged ? "done" : "did not converge",
                             summary.seconds);
  } catch (...) {
    observer.clear();
    throw;
  }
}

/// What the folder of a run says about it.
results::StudyEntry entry_of(const scenario::StudyRun& run, const fs::path& folder,
                             const std::vector<results::PublishedValue>& published) {
  results::StudyEntry entry;
  entry.variant = run.variant;
  entry.scenario = run.scenario.name;
  entry.expression = scenario::expression_of(run.scenario);
  entry.published = results::about_expression(published, entry.expression);
  const std::optional<results::RunRecord> record = results::read_run_record(folder);
  if (!record) throw DataError({{folder.string(), "holds no summary.json", "a finished run", ""}});
  entry.converged = record->status == results::name(results::Status::done);
  entry.reason = record->reason.substr(0, record->reason.find('\n'));
  if (entry.converged) entry.measured = record->measured;
  return entry;
}

void write_tables(const fs::path& out, const scenario::Study& study,
                  const std::vector<results::StudyEntry>& entries) {
  std::vector<results::StudyVariant> variants;
  for (const scenario::Variant& variant : study.variants)
    variants.push_back({variant.name, variant.about});
  write_file(out / "study.csv", results::study_csv(entries));
  write_file(out / "study.md", results::study_page(study.title.empty() ? study.name : study.title,
                                                   variants, entries));
}

int finish(const fs::path& out, const std::vector<results::StudyEntry>& entries) {
  std::cout << results::study_text(results::make_study_table(entries))
            << fmt::format("{} runs: {}\n", entries.size(), (out / "study.md").string());
  std::vector<Problem> failures;
  for (const results::StudyEntry& entry : entries) {
    if (!entry.converged)
      failures.push_back({entry.variant + "/" + entry.scenario, entry.reason, "", ""});
  }
  print_problems(std::cerr, failures);
  return failures.empty() ? exit_status::done : exit_status::not_converged;
}

int carry_out(const StudyCommand& command) {
  std::vector<bool> is_paper_face;
  const scenario::Study study = read_checked(command, is_paper_face);
  const auto paper =
      results::read_published(scenario::data_folder() / "published" / "flynn2015.csv");
  const fs::path out = command.out;
  results::prepare_study_folder(out, command.force);
  write_file(out / results::study_file, study.text);

  const solve::Session session;
  listen_for_stop();
  std::vector<results::StudyEntry> entries;
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const scenario::StudyRun& run = study.runs[i];
    const scenario::RunOptions options = options_of(command, run);
    const std::string label =
        fmt::format("{}/{} {}/{}: ", i + 1, study.runs.size(), run.variant, run.scenario.name);
    try {
      carry_out(run, options, command.force, label);
    } catch (const Interrupted&) {
      std::cerr << "interrupted; the same command goes on with this run\n";
      return exit_status::interrupted;
    }
    const bool has_paper = is_paper_face[i];
    entries.push_back(
        entry_of(run, options.out, has_paper ? paper : std::vector<results::PublishedValue>{}));
    write_tables(out, study, entries);
  }
  return finish(out, entries);
}

}  // namespace

void add_study(CLI::App& app, Action& action) {
  auto command = std::make_shared<StudyCommand>();
  CLI::App* sub = app.add_subcommand(
      "study",
      "Run named variants of scenarios, one after the other, and put them in one table.\n"
      "What is finished is not run again: a study that was stopped goes on where it was.\n\n"
      "Examples:\n"
      "  facies study open-choices --face artisynth:DIR --out out/open-choices\n"
      "  facies study my-study.yaml --out out/mine --pictures\n");
  sub->add_option("study", command->study,
                  "file, or name of a study that ships (facies list studies)")
      ->required()
      ->type_name("FILE");
  sub->add_option("--face", command->face,
                  "whose face (facies list faces); replaces that of the scenarios")
      ->type_name("SPEC");
  sub->add_option("--out", command->out, "folder of the study")->required()->type_name("DIR");
  sub->add_flag("--force", command->force,
                "run everything again; replace the results of a run that are in DIR");
  sub->add_flag("--pictures", command->pictures, "draw the pictures of every run");
  sub->add_option("--threads", command->threads, "threads; 0: all (results do not depend on it)")
      ->type_name("N")
      ->check(CLI::Range(0, 1024));
  sub->callback([command, &action] { action = [command] { return carry_out(*command); }; });
}

}  // namespace facies::cli
