#include "deploy/learning_curve.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace ronda {

std::vector<CurvePoint> ReadLearningCurve(const std::filesystem::path& metrics_file) {
  std::vector<CurvePoint> curve;
  std::ifstream file(metrics_file);
  for (std::string text; std::getline(file, text);) {
    const auto line = nlohmann::json::parse(text, nullptr, false);
    if (!line.is_object() || line.value("kind", "") != "evaluation") continue;
    curve.push_back({.training_s = line.value("time_s", 0.0), .agi_s = line.value("agi_s", 0.0)});
  }
  return curve;
}

}  // namespace ronda
