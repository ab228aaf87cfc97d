#include "common/run/metrics_log.h"

#include <nlohmann/json.hpp>

namespace ronda {

MetricsLog::MetricsLog(const std::filesystem::path& path, const std::string& process_name)
    : process_name_(process_name), lines_(path, "metrics") {}

void MetricsLog::Append(double time_s, const std::vector<Metric>& metrics) {
  nlohmann::ordered_json line{{"time_s", time_s}, {"process", process_name_}};
  for (const Metric& metric : metrics) {
    std::visit([&](const auto& value) { line[metric.name] = value; }, metric.value);
  }
  lines_.Append(line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace ronda
