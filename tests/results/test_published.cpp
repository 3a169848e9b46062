// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <gmock/gmock.h>

#include "results/cases.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/published.hpp"

namespace facies::results {
namespace {

using ::testing::HasSubstr;

std::vector<PublishedValue> flynn() {
  return read_published(std::filesystem::path(FACIES_SOURCE_DIR) / "data/published/flynn2015.csv");
}

TEST(Flynn2015, StatesEveryNumberInTheSentenceThatItQuotes) {
  for (const PublishedValue& value : flynn()) {
    EXPECT_THAT(value.sentence, HasSubstr(fmt::format("{:g}", std::abs(value.value))))
        << value.expression << ' ' << value.subject;
    if (value.comparison != "stated") {
      EXPECT_THAT(value.sentence, HasSubstr(value.comparison));
    }
    EXPECT_THAT(value.place, HasSubstr("Results"));
    if (value.value < 0.0) {
      EXPECT_THAT(value.sentence, ::testing::AnyOf(HasSubstr("decreased"), HasSubstr("reduced")));
    }
  }
}

TEST(Flynn2015, SaysOneThingOnceAboutEachExpression) {
  const std::vector<PublishedValue> values = flynn();
  EXPECT_EQ(values.size(), 14U);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(values[i].expression == values[k].expression &&
                   values[i].quantity == values[k].quantity &&
                   values[i].subject == values[k].subject);
    }
  }
  EXPECT_EQ(about_expression(values, "smile-open").size(), 7U);
  EXPECT_TRUE(about_expression(values, "frown").empty());
}

TEST(Flynn2015, HasTheHeadlineNumbers) {
  const std::vector<PublishedValue> values = flynn();
  const auto value_of = [&](const char* expression, const char* subject) {
    const auto found = std::find_if(values.begin(), values.end(), [&](const PublishedValue& v) {
      return v.expression == expression && v.subject == subject;
    });
    return found == values.end() ? std::string("none") : found->text();
  };
  EXPECT_EQ(value_of("smile-open", "RMC"), "12");
  EXPECT_EQ(value_of("smile-open", "RC-RMC"), "-18");
  EXPECT_EQ(value_of("smile-open", "PH-SL"), "almost 30");
  EXPECT_EQ(value_of("smile-closed", "RMC"), "10.7");
  EXPECT_EQ(value_of("lips-down", "RMC"), "about 11");
  EXPECT_EQ(value_of("purse", "RMC LMC RMU PH RML SL"), "up to 14");
}

class PublishedTable : public InFolder {
 protected:
  [[nodiscard]] std::string complaint(const std::string& content) const {
    write_file(folder_ / "table.csv", content);
    try {
      static_cast<void>(read_published(folder_ / "table.csv"));
    } catch (const DataError& error) {
      return error.what();
    }
    ADD_FAILURE() << "was accepted";
    return "";
  }
  static constexpr const char* header =
      "expression,quantity,subject,value,unit,comparison,place,sentence\n";
};

TEST_F(PublishedTable, MayQuoteCommasAndQuotes) {
  write_file(folder_ / "table.csv",
             std::string("# remark\n\n") + header +
                 "a,displacement,PG,2.5,mm,about,\"p. 1, top\",\"so \"\"wide\"\"\"\r\n");
  const auto values = read_published(folder_ / "table.csv");
  ASSERT_EQ(values.size(), 1U);
  EXPECT_EQ(values[0].place, "p. 1, top");
  EXPECT_EQ(values[0].sentence, "so \"wide\"");
  EXPECT_EQ(values[0].text(), "about 2.5");
}

TEST_F(PublishedTable, TellsEveryWrongLineAtOnce) {
  const std::string text =
      complaint(std::string(header) +
                "a,displacment,PG,2.5,mm,about,p,s\na,displacement,PG,wide,mm,about,p,s\na,b\n");
  EXPECT_THAT(text, HasSubstr("table.csv:2: unknown quantity 'displacment'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'displacement'?"));
  EXPECT_THAT(text, HasSubstr("table.csv:3: 'wide'; expected a number"));
  EXPECT_THAT(text, HasSubstr("table.csv:4: 2 columns"));
}

TEST_F(PublishedTable, NeedsItsHeader) {
  EXPECT_THAT(complaint(""), HasSubstr("holds no table"));
  EXPECT_THAT(complaint("a,b\n"), HasSubstr("expected expression,quantity"));
  EXPECT_THROW(static_cast<void>(read_published(folder_ / "none.csv")), DataError);
}

}  // namespace
}  // namespace facies::results
