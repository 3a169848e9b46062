// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/files.hpp"
#include "facies/base/text.hpp"
#include "facies/results/run_record.hpp"
#include "facies/results/study_table.hpp"

namespace facies::results {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Optional;

const std::vector<PublishedValue> smile{
    {"smile", "displacement", "RMC", 12.0, "mm", "stated", "", ""},
    {"smile", "distance_change", "RMC-LMC", 18.0, "%", "almost", "", ""},
    {"smile", "mean_tension_rotation", "skin", 25.0, "deg", "stated", "", ""}};
const std::vector<PublishedValue> purse{
    {"purse", "largest_displacement", "RMC PH", 14.0, "mm", "up to", "", ""}};

StudyEntry smiles(const std::string& variant, double rmc, double width) {
  return {variant,
          "smile",
          "smile",
          true,
          "",
          {{"displacement", "RMC", "mm", rmc},
           {"displacement", "SN", "mm", 1.0},
           {"distance_change", "RMC-LMC", "%", width}},
          smile};
}

StudyEntry purses(const std::string& variant, double rmc, double ph) {
  return {variant, "purse", "purse",
          true,    "",      {{"displacement", "RMC", "mm", rmc}, {"displacement", "PH", "mm", ph}},
          purse};
}

/// The words of the line that begins with `name`.
std::vector<std::string_view> row(const std::string& text, std::string_view name) {
  for (const std::string_view line : split(text, '\n')) {
    const std::vector<std::string_view> words = split_blanks(line);
    if (!words.empty() && words.front() == name) return words;
  }
  return {};
}

TEST(StudyTable, PutsTheVariantFirstThatMeetsMostAndOfSeveralTheNearest) {
  // Bands: 1.8 mm, 4 points, 2.1 mm.
  const std::vector<StudyEntry> entries{
      smiles("far", 15.6, 10.0),    purses("far", 3.0, 14.0),    smiles("two", 12.0, 18.0),
      purses("two", 3.0, 18.2),     smiles("near", 12.9, 20.0),  purses("near", 16.0, 3.0),
      smiles("nearer", 12.0, 20.0), purses("nearer", 14.0, 3.0), smiles("half", 12.0, 18.0)};
  const StudyTable table = make_study_table(entries);
  std::vector<std::string> order;
  for (const StudyRow& row : table.rows)
    order.push_back(row.variant);
  EXPECT_THAT(order, ElementsAre("nearer", "near", "two", "far", "half"));
  EXPECT_THAT(table.rows[1].score, Optional(DoubleNear((0.5 + 0.5 + 2.0 / 2.1) / 3, 1e-12)));
  EXPECT_THAT(table.rows[2].score, Optional(DoubleNear((0.0 + 0.0 + 2.0) / 3, 1e-12)));
  EXPECT_THAT(table.rows[3].score, Optional(DoubleNear((2.0 + 2.0 + 0.0) / 3, 1e-12)));
  EXPECT_EQ(table.rows[3].n_met, 1);
  const std::string text = study_text(table);
  EXPECT_THAT(row(text, "smile"), ElementsAre("smile", "purse"));
  EXPECT_THAT(row(text, "RMC"), ElementsAre("RMC", "RMC-LMC", "largest"));
  EXPECT_THAT(row(text, "paper"), ElementsAre("paper", "12", "almost", "18", "up", "to", "14"));
  EXPECT_THAT(row(text, "near"), ElementsAre("near", "12.90", "+20.0", "16.00", "3/3", "0.65"));
  EXPECT_LT(text.find("paper"), text.find("near"));
  EXPECT_LT(text.find("near"), text.find("far"));
}

TEST(StudyTable, PutsVariantsThatFailedLastAndCountsOnlyWhatConverged) {
  StudyEntry failed = purses("lame", 14.0, 14.0);
  failed.converged = false;
  failed.reason = "express did not converge";
  failed.measured.clear();
  const std::vector<StudyEntry> entries{smiles("lame", 12.0, 18.0), failed,
                                        smiles("other", 15.6, 10.0)};
  const StudyTable table = make_study_table(entries);
  EXPECT_EQ(table.rows[0].variant, "other");
  EXPECT_THAT(table.rows[1].score, Optional(0.0));
  const std::string text = study_text(table);
  EXPECT_THAT(row(text, "lame"), ElementsAre("lame", "12.00", "+18.0", "failed", "2/2", "0.00"));
  EXPECT_THAT(row(text, "other"), ElementsAre("other", "15.60", "+10.0", "-", "0/2", "2.00"));
  const std::string page = study_page("Choices", std::vector<StudyVariant>{{"lame", "x"}}, entries);
  EXPECT_THAT(page, HasSubstr("# Choices\n\n| variant | smile<br>RMC [mm] |"));
  EXPECT_THAT(page, HasSubstr("- `lame/purse`: express did not converge\n"));
  EXPECT_THAT(study_csv(entries), HasSubstr("\nlame,purse,largest_displacement RMC PH,mm,,14,\n"));
}

TEST(StudyTable, ShowsWhatWasMeasuredWhereNothingIsPublished) {
  StudyEntry entry = smiles("only", 12.5, 20.0);
  entry.published.clear();
  const std::string text = study_text(make_study_table(std::vector{entry}));
  EXPECT_THAT(row(text, "only"), ElementsAre("only", "12.50", "1.00", "+20.0", "-", "-"));
  EXPECT_THAT(text, Not(HasSubstr("paper")));
  EXPECT_THAT(make_study_table({}).rows, IsEmpty());
}

TEST(StudyCsv, HasARowForEverythingMeasuredOrPublished) {
  EXPECT_EQ(study_csv(std::vector{smiles("a", 12.5, 17.0)}),
            "variant,scenario,quantity,unit,value,paper,difference\n"
            "a,smile,displacement RMC,mm,12.5,12,0.5\n"
            "a,smile,distance_change RMC-LMC,%,17,18,-1\n"
            "a,smile,displacement SN,mm,1,,\n");
}

class Record : public InFolder {};

TEST_F(Record, ReadsBackWhatASummarySays) {
  Summary summary;
  summary.version = "1.2.3";
  summary.status = Status::not_converged;
  summary.reason = "too much";
  summary.settings_json = "{}";
  summary.inputs = {{"a.yaml", "sha256:12"}};
  Headline& headline = summary.headlines.emplace_back();
  headline.landmarks = {{"RMC", {}, {}, 11.25}};
  headline.pairs = {{"RMC", "LMC", 50.0, 58.5, 17.0}};
  headline.jaw = JawMeasure{41.5, {}};
  headline.volumes = {1.0, 1.0, 1.0};
  write_file(folder_ / "summary.json", to_json(summary));
  const std::optional<RunRecord> record = read_run_record(folder_);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->version, "1.2.3");
  EXPECT_EQ(record->status, "not_converged");
  EXPECT_EQ(record->reason, "too much");
  EXPECT_EQ(record->inputs.at(0).checksum, "sha256:12");
  const auto measured = [&](const char* quantity, const char* subject) {
    PublishedValue wanted;
    wanted.quantity = quantity;
    wanted.subject = subject;
    return measured_of(wanted, record->measured);
  };
  EXPECT_THAT(measured("displacement", "RMC"), Optional(11.25));
  EXPECT_THAT(measured("largest_displacement", "LMC RMC"), Optional(11.25));
  EXPECT_THAT(measured("distance_change", "RMC-LMC"), Optional(17.0));
  EXPECT_THAT(measured("incisor_distance", "incisors"), Optional(41.5));
  EXPECT_FALSE(measured("displacement", "PG"));
}

TEST_F(Record, IsNothingWhereThereIsNoSummary) {
  EXPECT_FALSE(read_run_record(folder_));
  for (const char* text :
       {"", "[]", "{\"facies\": 3}", "{\"facies\": \"1\", \"status\": \"done\"}"}) {
    write_file(folder_ / "summary.json", text);
    EXPECT_FALSE(read_run_record(folder_)) << text;
  }
}

}  // namespace
}  // namespace facies::results
