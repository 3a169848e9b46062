// SPDX-License-Identifier: Apache-2.0
#include "facies/results/run_record.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/base/text.hpp"

namespace facies::results {

namespace {

using Json = nlohmann::ordered_json;

std::vector<MeasuredValue> read_measures(const Json& measures) {
  std::vector<MeasuredValue> values;
  if (measures.empty()) return values;
  const Json& last = measures.back();
  for (const auto& [name, landmark] : last.at("landmarks").items())
    values.push_back({"displacement", name, "mm", landmark.at("displacement_mm").get<double>()});
  for (const auto& [pair, distance] : last.at("distances").items())
    values.push_back({"distance_change", pair, "%", distance.at("change_percent").get<double>()});
  if (last.contains("jaw")) {
    values.push_back({"incisor_distance", "incisors", "mm",
                      last.at("jaw").at("incisor_distance_mm").get<double>()});
  }
  return values;
}

std::optional<double> look_up(std::string_view quantity, std::string_view subject,
                              const std::vector<MeasuredValue>& measured) {
  const auto found = std::ranges::find_if(measured, [&](const MeasuredValue& value) {
    return value.quantity == quantity && value.subject == subject;
  });
  if (found == measured.end()) return std::nullopt;
  return found->value;
}

}  // namespace

std::optional<RunRecord> read_run_record(const std::filesystem::path& folder) {
  try {
    const Json json = Json::parse(read_file(folder / "summary.json"));
    RunRecord record;
    record.version = json.at("facies").get<std::string>();
    record.status = json.at("status").get<std::string>();
    record.reason = json.value("reason", "");
    for (const auto& [name, checksum] : json.at("inputs").items())
      record.inputs.push_back({name, checksum.get<std::string>()});
    record.measured = read_measures(json.at("measures"));
    return record;
  } catch (const DataError&) {  // there is none
    return std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::optional<double> measured_of(const PublishedValue& published,
                                  const std::vector<MeasuredValue>& measured) {
  if (published.quantity != "largest_displacement")
    return look_up(published.quantity, published.subject, measured);
  std::optional<double> largest;
  for (const std::string_view landmark : split_blanks(published.subject)) {
    const std::optional<double> own = look_up("displacement", landmark, measured);
    if (own && *own > largest.value_or(0.0)) largest = own;
  }
  return largest;
}

}  // namespace facies::results
