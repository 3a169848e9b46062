// SPDX-License-Identifier: Apache-2.0
// Many runs in one table: variants of a study beside each other and beside what was published.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "facies/results/published.hpp"
#include "facies/results/run_record.hpp"

namespace facies::results {

/// One run of a study.
struct StudyEntry {
  std::string variant;
  std::string scenario;    ///< name of its folder
  std::string expression;  ///< that it is compared with
  bool converged = false;
  std::string reason;                     ///< why it did not; empty otherwise
  std::vector<MeasuredValue> measured;    ///< nothing where it did not converge
  std::vector<PublishedValue> published;  ///< about this expression; none where the face is another
};

/// `variant,scenario,quantity,unit,value,paper,difference`: a row for everything that was measured or published, in the
/// order of the runs. What is not known is empty: values of runs that did not converge, numbers that no paper gives.
[[nodiscard]] std::string study_csv(std::span<const StudyEntry> entries);

/// One quantity of one expression.
struct StudyColumn {
  std::string expression;
  std::string quantity, subject, unit;
  std::optional<PublishedValue> paper;
};

struct StudyCell {
  std::optional<double> value;
  bool failed = false;  ///< the run did not converge
};

struct StudyRow {
  std::string variant;
  std::vector<StudyCell> cells;  ///< one per column
  int n_compared = 0;            ///< cells with a value beside a published one
  int n_met = 0;                 ///< of these, no farther from it than its band
  /// Mean of |difference| / band; nothing where none is compared.
  std::optional<double> score = std::nullopt;
  bool failed = false;  ///< a run of the variant did not converge
};

struct StudyTable {
  std::vector<StudyColumn> columns;
  std::vector<StudyRow> rows;
};

/// How far from a published value counts as 1: 15 % of a length, 4 percentage points of a change.
[[nodiscard]] double band_of(const PublishedValue& published);

/// A column for every quantity that was published and measured, or, where nothing is published, for every one that was
/// measured. A row for every variant: those that meet most published values first, of these the best score; then variants that are
/// compared with fewer values than others, then those with a run that did not converge.
[[nodiscard]] StudyTable make_study_table(std::span<const StudyEntry> entries);

/// For a terminal: the paper's row first; "failed" stands where a run did not converge, "-" where nothing was run.
[[nodiscard]] std::string study_text(const StudyTable& table);

/// What a variant of the study is about.
struct StudyVariant {
  std::string name;
  std::string about;  ///< may be empty
};

/// The study as a page in Markdown: the table and how to read it, runs that did not converge, the variants.
[[nodiscard]] std::string study_page(const std::string& title,
                                     std::span<const StudyVariant> variants,
                                     std::span<const StudyEntry> entries);

}  // namespace facies::results
