#include "deploy/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "deploy/colour_scale.h"
#include "deploy/terminal_text.h"

namespace ronda {
namespace {

// All in px of the picture.
constexpr double kPlotWidth = 900.0;
constexpr double kPlotHeight = 660.0;
constexpr double kLeastWidth = 560.0;  // room for scale bar and legend side by side
constexpr double kMargin = 36.0;
constexpr double kTitleHeight = 44.0;
constexpr double kFooterHeight = 64.0;
constexpr double kLegendWidth = 260.0;
constexpr double kWidestEdge = 9.0;

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : Harmless(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

struct Box {
  Position low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Position high{-low.x_m, -low.y_m};
};

Box BoxOf(const PatrolGraph& graph) {
  Box box;
  for (const Position& at : graph.positions()) {
    box.low = {std::min(box.low.x_m, at.x_m), std::min(box.low.y_m, at.y_m)};
    box.high = {std::max(box.high.x_m, at.x_m), std::max(box.high.y_m, at.y_m)};
  }
  return box;
}

/// Where things go, and how large they are.
class Layout {
 public:
  explicit Layout(const PatrolGraph& graph) : box_(BoxOf(graph)) {
    const double width_m = box_.high.x_m - box_.low.x_m;
    const double height_m = box_.high.y_m - box_.low.y_m;
    px_per_m_ = std::min(kPlotWidth / width_m, kPlotHeight / height_m);
    if (!std::isfinite(px_per_m_)) px_per_m_ = 1.0;  // all on one point
    plot_height_ = height_m * px_per_m_;
    const double plot_width = width_m * px_per_m_;
    width_ = std::max(plot_width, kLeastWidth) + 2.0 * kMargin;
    left_ = 0.5 * (width_ - plot_width);
  }

  double width() const { return width_; }
  double height() const { return footer() + kFooterHeight; }
  double footer() const { return kTitleHeight + plot_height_ + 2.0 * kMargin; }
  double px_per_m() const { return px_per_m_; }
  double x(const Position& at) const { return left_ + (at.x_m - box_.low.x_m) * px_per_m_; }
  double y(const Position& at) const {
    return kTitleHeight + kMargin + (box_.high.y_m - at.y_m) * px_per_m_;
  }

 private:
  Box box_;
  double px_per_m_ = 1.0;
  double width_ = 0.0;
  double plot_height_ = 0.0;
  double left_ = 0.0;
};

/// A quarter of the edges is shorter than this on the picture.
double Gap(const PatrolGraph& graph, double px_per_m) {
  std::vector<double> lengths;
  for (const Edge& edge : graph.edges()) {
    lengths.push_back(px_per_m *
                      Distance_m(graph.positions()[edge.source], graph.positions()[edge.target]));
  }
  const auto quarter = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 4);
  std::nth_element(lengths.begin(), quarter, lengths.end());
  return *quarter;
}

/// How vertices and their ids are drawn.
struct VertexStyle {
  double radius = 0.0;
  double font = 0.0;   // 0: no ids
  bool inside = true;  // the circle, else beside it
};

VertexStyle StyleOf(const PatrolGraph& graph, double gap, ShowIds ids) {
  constexpr double kLegibleGap = 28.0;
  constexpr double kLeastFont = 7.0;
  constexpr double kColumn = 0.6;  // width of a character over the font's size
  if (ids == ShowIds::kWhereLegible && gap < kLegibleGap) {
    return {.radius = std::clamp(0.25 * gap, 1.5, 8.0)};
  }
  int columns = 1;
  for (int v = 0; v < graph.vertex_count(); ++v) {
    columns = std::max(columns, DisplayColumns(Harmless(graph.vertex_id(v))));
  }
  const double radius = std::clamp(0.34 * gap, 2.5, 13.0);
  const double font = std::min(1.1 * radius, 1.75 * radius / (kColumn * columns));
  if (font >= kLeastFont) return {.radius = radius, .font = font, .inside = true};
  return {
      .radius = std::min(radius, 6.0), .font = std::clamp(0.4 * gap, 6.0, 11.0), .inside = false};
}

class MapPicture {
 public:
  MapPicture(const PatrolGraph& graph, const MapColours& colours, ShowIds ids)
      : graph_(graph),
        colours_(colours),
        layout_(graph),
        gap_(Gap(graph, layout_.px_per_m())),
        style_(StyleOf(graph, gap_, ids)) {
    if (!colours.of_vertices.empty()) {
      const auto [least, most] = std::ranges::minmax(colours.of_vertices);
      vertex_scale_.emplace(least, most);
    }
    if (!colours.of_edges.empty()) edge_scale_.emplace(0.0, std::ranges::max(colours.of_edges));
  }

  std::string Draw() {
    Add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"Helvetica, Arial, sans-serif\" "
        "font-size=\"13\" fill=\"#222222\">\n<title>{2}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        layout_.width(), layout_.height(), Escaped(graph_.name()));
    Add("<text x=\"{:.1f}\" y=\"30\" font-size=\"16\" font-weight=\"bold\">{}"
        "<tspan font-size=\"13\" font-weight=\"normal\" dx=\"10\">{} vertices, {} edge{}</tspan>"
        "</text>\n",
        kMargin, Escaped(graph_.name()), graph_.vertex_count(), graph_.edge_count(),
        graph_.edge_count() == 1 ? "" : "s");
    DrawEdges();
    DrawVertices();
    DrawScaleBar();
    if (vertex_scale_) DrawLegend(*vertex_scale_);
    if (edge_scale_) DrawLegend(*edge_scale_);
    return std::move(text_) + "</svg>\n";
  }

 private:
  template <typename... Values>
  void Add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  /// The busiest last, on top; below each a grey line that keeps light ones visible.
  void DrawEdges() {
    std::vector<int> order(graph_.edge_count());
    std::iota(order.begin(), order.end(), 0);
    if (edge_scale_) {
      std::ranges::stable_sort(order, {}, [&](int e) { return colours_.of_edges[e]; });
    }
    Add("<g stroke-linecap=\"round\">\n");
    for (const int e : order) {
      const Edge& edge = graph_.edges()[e];
      const std::string what =
          Escaped(fmt::format("{} - {}, {:.4g} m", graph_.vertex_id(edge.source),
                              graph_.vertex_id(edge.target), edge.length_m));
      if (!edge_scale_) {
        DrawLine(edge, "#8a8a8a", std::clamp(0.08 * gap_, 0.8, 2.5), what);
        continue;
      }
      const double value = colours_.of_edges[e];
      const double width =
          std::clamp(0.3 * gap_, 2.0, kWidestEdge) * (0.25 + 0.75 * edge_scale_->Share(value));
      DrawLine(edge, "#777777", width + 1.4, "");
      DrawLine(edge, edge_scale_->Colour(value), width, fmt::format("{}: {:.4g}", what, value));
    }
    Add("</g>\n");
  }

  void DrawLine(const Edge& edge, std::string_view colour, double width, std::string_view what) {
    const Position& from = graph_.positions()[edge.source];
    const Position& to = graph_.positions()[edge.target];
    Add("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"{:.1f}\"",
        layout_.x(from), layout_.y(from), layout_.x(to), layout_.y(to), colour, width);
    if (what.empty()) {
      Add("/>\n");
    } else {
      Add("><title>{}</title></line>\n", what);
    }
  }

  void DrawVertices() {
    Add("<g stroke=\"#333333\" stroke-width=\"{:.1f}\">\n", std::min(1.0, 0.2 * style_.radius));
    for (int v = 0; v < graph_.vertex_count(); ++v) {
      const Position& at = graph_.positions()[v];
      std::string what = Escaped(graph_.vertex_id(v));
      if (vertex_scale_) what += fmt::format(": {:.4g}", colours_.of_vertices[v]);
      Add("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"><title>{}</title>"
          "</circle>\n",
          layout_.x(at), layout_.y(at), style_.radius,
          vertex_scale_ ? vertex_scale_->Colour(colours_.of_vertices[v]) : "#e8eef7", what);
    }
    Add("</g>\n");
    if (style_.font > 0.0) DrawIds();
  }

  void DrawIds() {
    Add("<g font-size=\"{:.1f}\"{}>\n", style_.font,
        style_.inside ? " text-anchor=\"middle\" pointer-events=\"none\""
                      : " paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"2.5\"");
    for (int v = 0; v < graph_.vertex_count(); ++v) {
      const Position& at = graph_.positions()[v];
      const bool is_dark =
          style_.inside && vertex_scale_ && vertex_scale_->IsDark(colours_.of_vertices[v]);
      const double beside = style_.inside ? 0.0 : style_.radius + 1.5;
      Add("<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", layout_.x(at) + beside,
          layout_.y(at) - beside + (style_.inside ? 0.36 * style_.font : 0.0),
          is_dark ? " fill=\"#ffffff\"" : "", Escaped(graph_.vertex_id(v)));
    }
    Add("</g>\n");
  }

  void DrawScaleBar() {
    constexpr double kLongest = 180.0;
    const double length_m = RoundBelow(kLongest / layout_.px_per_m());
    const double right = kMargin + length_m * layout_.px_per_m();
    const double y = layout_.footer() + 22.0;
    Add("<path d=\"M{0:.1f} {2:.1f} v8 H{1:.1f} v-8\" fill=\"none\" stroke=\"#222222\" "
        "stroke-width=\"1.5\"/>\n<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"middle\">{5:.6g} "
        "m</text>\n",
        kMargin, right, y, 0.5 * (kMargin + right), y + 26.0, length_m);
  }

  void DrawLegend(const ColourScale& scale) {
    constexpr int kPieces = 65;
    const double left = layout_.width() - kMargin - kLegendWidth;
    const double y = layout_.footer() + 16.0;
    Add("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n<g shape-rendering=\"crispEdges\">\n", left,
        y - 7.0, Escaped(colours_.label));
    for (int k = 0; k < kPieces; ++k) {
      const double piece = kLegendWidth / kPieces;
      Add("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"14\" fill=\"{}\"/>\n",
          left + k * piece, y, piece, ColourScale::ColourAt((k + 0.5) / kPieces));
    }
    Add("</g>\n<g text-anchor=\"middle\" font-size=\"12\">\n");
    for (const double tick : scale.ticks()) {
      const double x = left + scale.Share(tick) * kLegendWidth;
      Add("<path d=\"M{0:.1f} {1:.1f} v5\" stroke=\"#222222\"/><text x=\"{0:.1f}\" y=\"{2:.1f}\">"
          "{3:.6g}</text>\n",
          x, y + 14.0, y + 31.0, tick);
    }
    Add("</g>\n");
  }

  const PatrolGraph& graph_;
  const MapColours& colours_;
  Layout layout_;
  double gap_;
  VertexStyle style_;
  std::optional<ColourScale> vertex_scale_;
  std::optional<ColourScale> edge_scale_;
  std::string text_;
};

}  // namespace

std::string DrawMap(const PatrolGraph& graph, const MapColours& colours, ShowIds ids) {
  return MapPicture(graph, colours, ids).Draw();
}

}  // namespace ronda
