// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/recorder.hpp"

#include <algorithm>

#include "facies/base/checksum.hpp"
#include "facies/base/files.hpp"
#include "facies/results/anatomy_pictures.hpp"
#include "facies/results/animation.hpp"
#include "facies/results/closing_table.hpp"
#include "facies/results/folder.hpp"
#include "facies/results/pictures.hpp"
#include "facies/results/tables.hpp"
#include "facies/scenario/mechanism_report.hpp"
#include "facies/scenario/settings_json.hpp"
#include "facies/scenario/subject.hpp"
#include "facies/scenario/write_scenario.hpp"
#include "facies/solve/motion.hpp"

namespace facies::scenario {

results::Subject make_subject(const FaceModel& model) {
  results::Subject subject =
      subject_of(model.face, model.muscles, model.jaw ? &*model.jaw : nullptr);
  subject.bodies.assign(model.model.bodies().begin(), model.model.bodies().end());
  return subject;
}

results::Snapshot make_snapshot(const FaceModel& model, const mechanics::State& state,
                                const mechanics::Controls& controls) {
  results::Snapshot snapshot;
  snapshot.state = state;
  snapshot.controls = controls;
  for (const mechanics::ElementMeans& means : model.solid->means(state, controls)) {
    snapshot.sigma.push_back(means.sigma);
    snapshot.J.push_back(means.J);
  }
  snapshot.jaw = measure_jaw(model, state);
  snapshot.contacts = measure_contacts(model, state);
  return snapshot;
}

namespace {

/// Height of each view of bones and sections, and in an animation, whose file is large [pixels].
constexpr int anatomy_height = 640;
constexpr int film_height = 560;

/// For the terminal: the landmarks of the paper and what stands beside them (PH_buried beside PH); all of a face that
/// has none of those. The tables in the folder hold every landmark.
void keep_main_landmarks(const anatomy::FaceAnatomy& face,
                         std::vector<results::LandmarkMeasure>& measures) {
  std::vector<std::string> main;
  for (const anatomy::Landmark& landmark : face.landmarks) {
    if (landmark.in_paper) main.push_back(landmark.name);
  }
  if (main.empty()) return;
  std::erase_if(measures, [&](const results::LandmarkMeasure& measure) {
    const std::string stem = measure.landmark.substr(0, measure.landmark.find('_'));
    return std::ranges::find(main, stem) == main.end();
  });
}

/// The scenario, where it is a file, the files of the face and tables of curves, each with what was in it.
std::vector<results::InputFile> inputs_of(const FaceModel& model, const Scenario& scenario) {
  std::vector<std::filesystem::path> files = model.face.files;
  std::error_code none;
  const std::filesystem::path written = where_of(scenario, "");
  if (std::filesystem::is_regular_file(written, none)) files.insert(files.begin(), written);
  for (const Step& step : scenario.steps) {
    const auto* move = std::get_if<MoveStep>(&step);
    if (move != nullptr && !move->curves.empty()) files.emplace_back(move->curves);
  }
  std::vector<results::InputFile> inputs;
  for (const std::filesystem::path& file : files)
    inputs.push_back({file.string(), "sha256:" + sha256(read_file(file))});
  return inputs;
}

}  // namespace

Recorder::Recorder(const FaceModel& model, const Scenario& scenario, const RunOptions& options,
                   solve::Observer& listener)
    : model_(model),
      scenario_(scenario),
      options_(options),
      listener_(listener),
      subject_(make_subject(model)),
      fields_(subject_, options.out),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {
  results::prepare_folder(options_.out, options_.force);
  log_.emplace(options_.out / "log.jsonl");
  const std::string resolved = to_yaml(scenario_);
  write_file(options_.out / "scenario.yaml", resolved);
  summary_.version = options_.version;
  summary_.settings_json = settings_json(resolved);
  summary_.inputs = inputs_of(model, scenario);
  summary_.settling = measure_settling(model);
  write_summary();
}

void Recorder::increment_begins(const solve::Increment& increment) {
  results::IncrementRecord& record = summary_.convergence.emplace_back();
  record.step = increment.step;
  record.step_number = increment.step_number;
  record.number = increment.number;
  record.from = increment.from;
  record.to = increment.to;
  listener_.increment_begins(increment);
}

void Recorder::iteration_done(const solve::Increment& increment,
                              const solve::Iteration& iteration) {
  results::IncrementRecord& record = summary_.convergence.back();
  record.iterations.push_back({iteration.number, iteration.residual, iteration.relative,
                               iteration.correction, iteration.step_length, iteration.shift,
                               iteration.factorisations, iteration.exact});
  log_->iteration(record, record.iterations.back());
  listener_.iteration_done(increment, iteration);
}

void Recorder::increment_ends(const solve::Increment& increment, const solve::IncrementEnd& end) {
  results::IncrementRecord& record = summary_.convergence.back();
  record.converged = end.converged;
  record.reason = end.reason;
  record.worst_node = end.worst_node;
  record.inadmissible = end.inadmissible;
  log_->increment(record);
  write_file(options_.out / "convergence.txt", results::convergence_text(summary_.convergence));
  listener_.increment_ends(increment, end);
}

const mechanics::State* Recorder::rest_state() const {
  return rest_ ? &snapshots_[*rest_].state : nullptr;
}

void Recorder::time_step_done(const solve::Motion& motion) {
  const solve::EnergyBooks& books = motion.energy;
  energy_ += summary_.convergence.back().step + ',' + results::exact_number(motion.time);
  for (const double value :
       {books.kinetic, books.potential, books.work, books.dissipated, books.numerical})
    energy_ += ',' + results::exact_number(value);
  energy_ += '\n';
  listener_.time_step_done(motion);
}

void Recorder::record_motion(const results::Snapshot& snapshot) {
  motion_ += results::motion_rows(subject_, snapshot, rest_state());
  write_file(options_.out / "motion.csv", results::motion_titles + motion_);
  if (!energy_.empty()) {
    write_file(
        options_.out / "energy.csv",
        "step,time_s,kinetic_uJ,potential_uJ,work_uJ,dissipated_uJ,numerical_uJ\n" + energy_);
  }
}

void Recorder::frame(results::Snapshot snapshot) {
  if (snapshot.load == 0.0) films_.emplace_back();
  if (snapshot.time) record_motion(snapshot);
  // The last frame is the state in which the step ends; the first, where time has not begun, that of the step before.
  const bool is_new = snapshot.load < 1.0 && (snapshot.load > 0.0 || snapshot.time);
  if (is_new && scenario_.output.fields == "steps")
    fields_.add_frame(snapshot, rest_state(), static_cast<int>(films_.back().size()));
  snapshot.sigma.clear();  // an animation shows none of it
  snapshot.J.clear();
  films_.back().push_back(std::move(snapshot));
}

void Recorder::step_ends(results::Snapshot snapshot, bool is_rest) {
  snapshots_.push_back(std::move(snapshot));
  if (is_rest) rest_ = snapshots_.size() - 1;
  const results::Snapshot& last = snapshots_.back();
  if (scenario_.output.fields == "steps") fields_.add(last, rest_state());
  summary_.headlines.push_back(results::make_headline(subject_, last, rest_state()));
  write_tables();
  write_summary();
}

void Recorder::write_tables() const {
  const results::History history{snapshots_, rest_};
  write_file(options_.out / "landmarks.csv", results::landmarks_csv(subject_, history));
  write_file(options_.out / "distances.csv", results::distances_csv(subject_, history));
}

void Recorder::write_summary() const {
  write_file(options_.out / "summary.json", results::to_json(summary_));
}

void Recorder::draw(int threads) {
  if (snapshots_.empty() || !scenario_.output.pictures || !options_.pictures) return;
  results::PictureOptions options{
      .title = scenario_.title.empty() ? scenario_.name : scenario_.title,
      .subject = model_.face.source,
      .threads = threads};
  const results::Snapshot* rest = rest_ ? &snapshots_[*rest_] : nullptr;
  const std::filesystem::path folder = options_.out / "figures";
  results::write_pictures(subject_, rest, snapshots_.back(), folder, options);
  options.height = anatomy_height;
  results::write_anatomy_pictures(subject_, snapshots_, folder, options);
  options.height = film_height;
  for (const std::vector<results::Snapshot>& film : films_)
    if (film.size() > 1) results::write_animation(subject_, film, folder, options);
}

void Recorder::finish(results::Status status, const std::string& reason, Index element) {
  if (scenario_.output.fields == "last" && !snapshots_.empty())
    fields_.add(snapshots_.back(), rest_state());
  summary_.status = status;
  summary_.reason = reason;
  if (element >= 0) summary_.where = results::place_of(subject_, element);
  write_summary();
}

void Recorder::time(const std::string& name) {
  const auto now = std::chrono::steady_clock::now();
  summary_.timings.emplace_back(name, std::chrono::duration<double>(now - last_).count());
  last_ = now;
}

double Recorder::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::string Recorder::closing_text() const {
  if (summary_.headlines.empty()) return {};
  std::vector<results::PublishedValue> published;
  if (model_.face.is_reference_face) {
    published = results::about_expression(
        results::read_published(options_.data / "published" / "flynn2015.csv"),
        expression_of(scenario_));
  }
  results::Headline headline = summary_.headlines.back();
  keep_main_landmarks(model_.face, headline.landmarks);
  return results::closing_text(headline, published);
}

}  // namespace facies::scenario
