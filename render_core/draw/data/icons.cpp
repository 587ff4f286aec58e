#include "render_core/draw/data/icons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/placement.hpp"

namespace tedavis::draw {
namespace {

constexpr float kIconStroke = 0.2f, kMinIconStroke_px = 1.4f, kIconRim_px = 1.2f;
constexpr int kCircleSides = 10;

/// Of -1..1, y down; from = to is a dot.
struct Stroke {
    float x0, y0, x1, y1;
};
struct Shape {
    base::Span<const Stroke> strokes;
    float circle = 0;        ///< radius round the middle; 0 for none
    bool is_filled = false;  ///< between its strokes, which go round the middle
};

constexpr Stroke kObstacle[] = {{-0.6f, 0.8f, 0, -0.9f}, {0.6f, 0.8f, 0, -0.9f}, {0, 0.8f, 0, 0.8f}};
constexpr Stroke kHighObstacle[] = {{-0.35f, 1, -0.15f, -0.5f},     {0.35f, 1, 0.15f, -0.5f},      {-0.3f, 0.6f, 0.2f, 0},
                                    {0.3f, 0.6f, -0.2f, 0},         {-0.15f, -0.5f, 0.15f, -0.5f}, {0, -0.5f, 0, -1},
                                    {-0.75f, -0.95f, -0.3f, -0.6f}, {0.75f, -0.95f, 0.3f, -0.6f}};
constexpr Stroke kMast[] = {{-0.45f, 1, 0, -1}, {0.45f, 1, 0, -1}, {-0.35f, 0.5f, 0.35f, 0.5f}, {-0.2f, -0.1f, 0.2f, -0.1f}};
constexpr Stroke kTurbine[] = {{0, 1, 0, -0.2f}, {0, -0.2f, 0, -1}, {0, -0.2f, 0.7f, 0.2f}, {0, -0.2f, -0.7f, 0.2f}};
constexpr Stroke kChimney[] = {
    {-0.4f, 1, -0.2f, -0.5f}, {0.4f, 1, 0.2f, -0.5f}, {-0.2f, -0.5f, 0.2f, -0.5f}, {-0.4f, 1, 0.4f, 1}, {0.1f, -0.8f, 0.8f, -1}};
constexpr Stroke kCrane[] = {
    {-0.3f, 1, -0.3f, -1}, {-0.9f, -0.6f, 0.9f, -0.6f}, {-0.3f, -1, 0.9f, -0.6f}, {0.6f, -0.6f, 0.6f, 0.1f}};
constexpr Stroke kPole[] = {{0, 1, 0, -1}, {-0.6f, -0.65f, 0.6f, -0.65f}};
constexpr Stroke kCable[] = {{-0.85f, 1, -0.85f, -0.8f}, {0.85f, 1, 0.85f, -0.8f}, {-0.85f, -0.8f, -0.4f, -0.35f},
                             {-0.4f, -0.35f, 0, -0.2f},  {0, -0.2f, 0.4f, -0.35f}, {0.4f, -0.35f, 0.85f, -0.8f}};
constexpr Stroke kDot[] = {{0, 0, 0, 0}};
constexpr Stroke kSummit[] = {{0, -0.8f, 0.85f, 0.7f}, {0.85f, 0.7f, -0.85f, 0.7f}, {-0.85f, 0.7f, 0, -0.8f}};
constexpr Stroke kAirport[] = {{-1, 0.4f, 1, -0.4f}};  // a runway through the circle
constexpr Stroke kDiamond[] = {{0, -0.9f, 0.9f, 0}, {0.9f, 0, 0, 0.9f}, {0, 0.9f, -0.9f, 0}, {-0.9f, 0, 0, -0.9f}};
constexpr Stroke kSample[] = {{0, 0.5f, 0, 1}, {-0.3f, 1, 0.3f, 1}};
constexpr Stroke kStorm[] = {{0.3f, -1, -0.4f, 0.1f}, {-0.4f, 0.1f, 0.3f, -0.05f}, {0.3f, -0.05f, -0.3f, 1}};
constexpr Stroke kNoGo[] = {{-0.6f, 0.6f, 0.6f, -0.6f}};
/// An aeroplane from above: fuselage, wings, tail.
constexpr Stroke kGhost[] = {
    {0, -1, 0, 0.8f}, {-1, 0.2f, 0, -0.3f}, {0, -0.3f, 1, 0.2f}, {-0.45f, 0.95f, 0, 0.7f}, {0, 0.7f, 0.45f, 0.95f}};
constexpr Stroke kModel[] = {{-0.7f, 0.9f, 0.7f, 0.9f},
                             {-0.7f, 0.9f, -0.7f, -0.1f},
                             {0.7f, 0.9f, 0.7f, -0.1f},
                             {-0.9f, -0.05f, 0, -0.9f},
                             {0.9f, -0.05f, 0, -0.9f}};

constexpr std::size_t kIcons = static_cast<std::size_t>(Icon::count);
constexpr std::array<std::string_view, kIcons> kNames = {
    "generic", "obstacle", "mast",    "turbine", "chimney", "crane", "pole",  "cable",        "place",         "village", "town",
    "summit",  "airport",  "traffic", "sample",  "storm",   "no_go", "model", "near_traffic", "high_obstacle", "ghost"};

Shape shape_of(Icon icon) {
    constexpr float kWhole = 0.9f, kPlace = 0.7f, kVillage = 0.5f, kBalloon = 0.5f, kField = 0.65f;
    switch (icon) {
        case Icon::obstacle: return {kObstacle};
        case Icon::mast: return {kMast};
        case Icon::turbine: return {kTurbine};
        case Icon::chimney: return {kChimney};
        case Icon::crane: return {kCrane};
        case Icon::pole: return {kPole};
        case Icon::cable: return {kCable};
        case Icon::place: return {{}, kPlace};
        case Icon::village: return {{}, kVillage};
        case Icon::town: return {kDot, kWhole};
        case Icon::summit: return {kSummit, 0, true};
        case Icon::airport: return {kAirport, kField};
        case Icon::sample: return {kSample, kBalloon};
        case Icon::storm: return {kStorm};
        case Icon::no_go: return {kNoGo, kWhole};
        case Icon::model: return {kModel};
        case Icon::high_obstacle: return {kHighObstacle};
        case Icon::near_traffic: return {kDiamond, 0, true};
        case Icon::ghost: return {kGhost};
        default: return {kDiamond};
    }
}

Icon icon_of(scene::LayerRole role, scene::LayerShape shape) {
    switch (role) {
        case scene::LayerRole::obstacle: return shape == scene::LayerShape::lines ? Icon::cable : Icon::obstacle;
        case scene::LayerRole::place: return Icon::place;
        case scene::LayerRole::runway: return Icon::airport;
        case scene::LayerRole::traffic: return Icon::traffic;
        case scene::LayerRole::sample: return Icon::sample;
        case scene::LayerRole::storm_cell: return Icon::storm;
        case scene::LayerRole::no_go: return Icon::no_go;
        case scene::LayerRole::building:
        case scene::LayerRole::model: return Icon::model;
        case scene::LayerRole::ghost: return Icon::ghost;
        default: return Icon::generic;
    }
}

/// Icon::count where there is none.
Icon icon_named(std::string_view name) {
    if (name == "peak") return Icon::summit;
    if (name == "aerodrome") return Icon::airport;
    for (std::size_t n = 0; n < kIcons; ++n)
        if (name == kNames[n]) return static_cast<Icon>(n);
    return Icon::count;
}

Point on_circle(Point middle, float radius_px, float turn) {
    const float angle = turn * 2 * static_cast<float>(base::kPi);
    return {middle.x + radius_px * std::cos(angle), middle.y + radius_px * std::sin(angle)};
}

Stroke turned(const Stroke& stroke, float turn_rad) {
    const float along = std::cos(turn_rad), across = std::sin(turn_rad);
    return {along * stroke.x0 - across * stroke.y0, across * stroke.x0 + along * stroke.y0,
            along * stroke.x1 - across * stroke.y1, across * stroke.x1 + along * stroke.y1};
}

struct IconLook {
    float half_px, width_px, turn_rad;
    design::Color color;
};

bool draw_shape(QuadBatch& batch, const Shape& shape, Point middle, const IconLook& look) {
    const auto [half_px, width_px, turn_rad, color] = look;
    bool fits = true;
    for (const Stroke& upright : shape.strokes) {
        const Stroke stroke = turn_rad == 0 ? upright : turned(upright, turn_rad);
        const float past = stroke.x0 == stroke.x1 && stroke.y0 == stroke.y1 ? width_px : 0;  // dots have a length
        fits = batch.line({middle.x + half_px * stroke.x0 - past, middle.y + half_px * stroke.y0},
                          {middle.x + half_px * stroke.x1 + past, middle.y + half_px * stroke.y1},
                          past > 0 ? 2 * width_px : width_px, color) &&
               fits;
    }
    for (const Stroke& stroke : shape.is_filled ? shape.strokes : base::Span<const Stroke>())
        fits = batch.triangle(middle, {middle.x + half_px * stroke.x0, middle.y + half_px * stroke.y0},
                              {middle.x + half_px * stroke.x1, middle.y + half_px * stroke.y1}, color) &&
               fits;
    if (shape.circle <= 0) return fits;
    Point corners[kCircleSides];
    for (int n = 0; n < kCircleSides; ++n)
        corners[n] = on_circle(middle, half_px * shape.circle, static_cast<float>(n) / kCircleSides);
    return batch.polyline(corners, width_px, color, true) && fits;
}

}  // namespace

Icon icon_of(const scene::Layer& layer, std::uint32_t feature) {
    const scene::Attribute* const kind = layer.find("kind");
    const double code = scene::value_or_nan(layer, "kind", feature);
    if (kind != nullptr && code >= 0 && kind->entry->class_count > 0)
        if (const Icon named = icon_named(kind->class_name(static_cast<std::uint32_t>(code))); named != Icon::count) return named;
    return icon_of(layer.entry->role, layer.entry->shape);
}

Icon icon_by_height(Icon icon, double height_m) {
    if (!(height_m >= kHighObstacle_m)) return icon;
    switch (icon) {
        case Icon::obstacle:
        case Icon::mast:
        case Icon::chimney:
        case Icon::crane:
        case Icon::pole: return Icon::high_obstacle;
        default: return icon;
    }
}

bool draw_icon(QuadBatch& batch, Icon icon, Point middle, float half_px, design::Color color, float turn_rad) {
    const Shape shape = shape_of(icon);
    const float width_px = std::max(kMinIconStroke_px, kIconStroke * half_px);
    const design::Color rim{0, 0, 0, color.alpha};
    const bool fits = draw_shape(batch, shape, middle, {half_px, width_px + 2 * kIconRim_px, turn_rad, rim});
    return draw_shape(batch, shape, middle, {half_px, width_px, turn_rad, color}) && fits;
}

bool draw_dashed_rim(QuadBatch& batch, Point middle, float radius_px, design::Color color, float share) {
    constexpr int kDashes = 8;
    bool fits = true;
    for (int n = 0; n < kDashes; ++n) {
        const float begin = static_cast<float>(n) / kDashes, end = (static_cast<float>(n) + share) / kDashes;
        const Point from = on_circle(middle, radius_px, begin), to = on_circle(middle, radius_px, end);
        fits = batch.line(from, to, kMinIconStroke_px + 2 * kIconRim_px, {0, 0, 0, color.alpha}) && fits;
        fits = batch.line(from, to, kMinIconStroke_px, color) && fits;
    }
    return fits;
}

}  // namespace tedavis::draw
