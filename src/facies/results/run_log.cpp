// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "facies/base/error.hpp"
#include "facies/results/convergence.hpp"

namespace facies::results {

namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void cannot_log(const std::filesystem::path& path, int error) {
  throw UsageError(
      {{path.string(), std::string("cannot write: ") + std::strerror(error), "",
        error == ENOSPC ? "free some space on that disk or choose another folder with --out"
                        : "choose a folder that you may write to with --out"}});
}

Json place(const char* event, const IncrementRecord& increment) {
  return {{"event", event},
          {"step", increment.step},
          {"step_number", increment.step_number},
          {"increment", increment.number},
          {"from", increment.from},
          {"to", increment.to}};
}

}  // namespace

RunLog::RunLog(std::filesystem::path path)
    : path_(std::move(path)),
      descriptor_(
          ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) cannot_log(path_, errno);
}

RunLog::~RunLog() {
  ::close(descriptor_);
}

void RunLog::iteration(const IncrementRecord& increment, const IterationRecord& iteration) {
  Json line = place("iteration", increment);
  line["iteration"] = iteration.number;
  line["residual_mN"] = iteration.residual;
  line["relative"] = iteration.relative;
  line["correction_mm"] = iteration.correction;
  line["step_length"] = iteration.step_length;
  line["exact_tangent"] = iteration.exact;
  line["shift"] = iteration.shift;
  line["factorisations"] = iteration.factorisations;
  write_line(line.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void RunLog::increment(const IncrementRecord& increment) {
  Json line = place("increment", increment);
  line["converged"] = increment.converged;
  line["reason"] = increment.reason;
  line["iterations"] = increment.corrections();
  line["factorisations"] = increment.factorisations();
  if (increment.worst_node >= 0) line["worst_node"] = increment.worst_node;
  if (increment.inadmissible.element >= 0) {
    line["inadmissible_element"] = increment.inadmissible.element;
    line["inadmissible_J"] = increment.inadmissible.J;
  }
  write_line(line.dump(-1, ' ', false, Json::error_handler_t::replace));
}

// One write for the whole line: a killed run leaves whole lines.
void RunLog::write_line(std::string line) {
  line += '\n';
  const char* rest = line.data();
  std::size_t n = line.size();
  while (n > 0) {
    const ssize_t written = ::write(descriptor_, rest, n);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) cannot_log(path_, errno);
    rest += written;
    n -= static_cast<std::size_t>(written);
  }
}

}  // namespace facies::results
