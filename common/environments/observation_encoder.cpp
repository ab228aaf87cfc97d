#include "common/environments/observation_encoder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "common/base/error.h"

namespace ronda {
namespace {

struct Named {
  ObservationScheme scheme;
  std::string_view name;
  std::string_view schema;
  bool takes_alpha = false;
};

/// In the order of the enum.
constexpr std::array kSchemes = {
    Named{ObservationScheme::kCandidates, "candidates", "patrol-candidates-26"},
    Named{ObservationScheme::kThesis, "thesis", "patrol-thesis-3"},
    Named{ObservationScheme::kSorted, "sorted", "patrol-sorted-2"},
    Named{ObservationScheme::kRanking, "ranking", "patrol-ranking-2", true},
    Named{ObservationScheme::kNormalised, "normalised", "patrol-normalised-2", true},
    Named{ObservationScheme::kCentred, "centred", "patrol-centred-2"},
    Named{ObservationScheme::kMatrix, "matrix", "patrol-matrix-1"},
};
constexpr std::string_view kAlphaMark = ".alpha-";
constexpr std::string_view kStayMark = ".stay";

constexpr bool InOrder() {
  for (std::size_t i = 0; i < kSchemes.size(); ++i) {
    if (static_cast<std::size_t>(kSchemes[i].scheme) != i) return false;
  }
  return true;
}
static_assert(InOrder());

const Named& Of(ObservationScheme scheme) { return kSchemes[static_cast<std::size_t>(scheme)]; }

const ObservationOptions& Checked(const ObservationOptions& options) {
  const Named& named = Of(options.scheme);
  if (options.alpha != 0.0 && (!(options.alpha > 1.0) || !std::isfinite(options.alpha))) {
    throw InputError(
        fmt::format("observation_alpha: must be 0 (off) or above 1, got {}", options.alpha));
  }
  if (options.alpha != 0.0 && !named.takes_alpha) {
    throw InputError(fmt::format(
        "observation_alpha: must be 0 (off) with the observation {}, got {}; the transform is for "
        "an idleness in 0 … 1, as of ranking and normalised",
        named.name, options.alpha));
  }
  if (options.scheme == ObservationScheme::kMatrix && options.robots < 1) {
    throw InputError(fmt::format("observation: matrix needs to know the number of robots, got {}",
                                 options.robots));
  }
  return options;
}

std::variant<CandidateEncoder, ThesisEncoder, MatrixEncoder> MakeEncoder(
    const PatrolGraph& graph, const ShortestPaths& paths, const ObservationOptions& options) {
  const auto vector_with = [&](IdlenessScale idleness, bool others = false) {
    return ThesisEncoder(
        graph, paths,
        {.idleness = idleness, .alpha = options.alpha, .others = others, .stay = options.stay});
  };
  switch (options.scheme) {
    case ObservationScheme::kCandidates:
      break;
    case ObservationScheme::kThesis:
      return vector_with(IdlenessScale::kRelative, true);
    case ObservationScheme::kSorted:
      return vector_with(IdlenessScale::kRelative);
    case ObservationScheme::kRanking:
      return vector_with(IdlenessScale::kRanking);
    case ObservationScheme::kNormalised:
      return vector_with(IdlenessScale::kNormalised);
    case ObservationScheme::kCentred:
      return vector_with(IdlenessScale::kCentred);
    case ObservationScheme::kMatrix:
      return MatrixEncoder(graph, options.robots, options.stay);
  }
  return CandidateEncoder(graph, paths, options.stay);
}

/// The α that `text` says, > 1 and finite, or 0 where it says none.
double ParseAlpha(std::string_view text) {
  double alpha = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), alpha);
  const bool is_alpha = error == std::errc() && end == text.data() + text.size() && alpha > 1.0 &&
                        std::isfinite(alpha);
  return is_alpha ? alpha : 0.0;
}

}  // namespace

std::vector<std::string> ObservationNames() {
  std::vector<std::string> names;
  for (const Named& named : kSchemes) names.emplace_back(named.name);
  return names;
}

ObservationScheme ParseObservationScheme(const std::string& name) {
  for (const Named& named : kSchemes) {
    if (name == named.name) return named.scheme;
  }
  throw UsageError(fmt::format("the observation must be one of {}, got '{}'",
                               fmt::join(ObservationNames(), ", "), name));
}

std::string_view Name(ObservationScheme scheme) { return Of(scheme).name; }

std::string Schema(const ObservationOptions& options) {
  const std::string_view schema = Of(options.scheme).schema;
  const std::string alpha =
      options.alpha == 0.0 ? "" : fmt::format("{}{:.17g}", kAlphaMark, options.alpha);
  return fmt::format("{}{}{}", schema, options.stay ? kStayMark : "", alpha);
}

ObservationOptions SchemeOf(const std::string& schema) {
  const std::size_t mark = std::min(schema.find(kAlphaMark), schema.size());
  const bool has_alpha = mark < schema.size();
  const double alpha =
      has_alpha ? ParseAlpha(std::string_view(schema).substr(mark + kAlphaMark.size())) : 0.0;
  std::string_view scheme = std::string_view(schema).substr(0, mark);
  const bool stay = scheme.ends_with(kStayMark);
  if (stay) scheme.remove_suffix(kStayMark.size());
  for (const Named& named : kSchemes) {
    if (named.schema != scheme) continue;
    if (has_alpha && (alpha == 0.0 || !named.takes_alpha)) break;
    ObservationOptions options(named.scheme, alpha);
    options.stay = stay;
    return options;
  }
  throw InputError(fmt::format("no observation here has the schema '{}'", schema));
}

ObservationEncoder::ObservationEncoder(const PatrolGraph& graph, const ShortestPaths& paths,
                                       const ObservationOptions& options)
    : options_(Checked(options)), encoder_(MakeEncoder(graph, paths, options)) {}

int ObservationEncoder::observation_size() const {
  return std::visit([](const auto& encoder) { return encoder.observation_size(); }, encoder_);
}

int ObservationEncoder::num_actions() const {
  return std::visit([](const auto& encoder) { return encoder.num_actions(); }, encoder_);
}

int ObservationEncoder::features_per_candidate() const {
  return std::holds_alternative<CandidateEncoder>(encoder_) ? CandidateEncoder::kFeatures : 0;
}

int ObservationEncoder::team_size() const {
  const auto* matrix = std::get_if<MatrixEncoder>(&encoder_);
  return matrix != nullptr ? matrix->robots() : 0;
}

void ObservationEncoder::Encode(const Belief& belief, std::span<float> observation,
                                std::span<std::uint8_t> legal_actions) {
  std::visit([&](auto& encoder) { encoder.Encode(belief, observation, legal_actions); }, encoder_);
}

int ObservationEncoder::NextVertex(int vertex, int action) const {
  return std::visit([&](const auto& encoder) { return encoder.NextVertex(vertex, action); },
                    encoder_);
}

}  // namespace ronda
