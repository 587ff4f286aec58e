#include "render_core/draw/data/tube_solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint32_t kBatchVerticesARing = 24, kMaxRings = 32768;
constexpr std::size_t kShareOfRoom = 2;  // one half
constexpr std::uint64_t kRingPadding_bytes = 64;
constexpr std::size_t kSideIndices = 36;
constexpr double kPostShare = 0.25;  // of the tube's radius
constexpr double kSteep = 0.9;       // of a unit tangent upwards, from which on a side cannot well face upwards
constexpr TubeColor kRimColor{{16, 16, 20, 255}, scene::Uncertainty::from_code(0)};

/// A ring more for each place where the way turns back on itself.
std::uint32_t with_cusps(std::uint32_t rings) { return rings + rings / 16 + 2; }

/// The same side faces upwards all along, however much of the way is left out; steep parts keep what was before them.
void keep_upright(base::Span<scene::TubeRing> rings) {
    for (std::size_t n = 0; n < rings.size(); ++n) {
        scene::TubeFrame& frame = rings[n].frame;
        const glm::dvec3 up = glm::normalize(rings[n].centre);
        const bool is_steep = std::abs(glm::dot(frame.tangent, up)) > kSteep;
        const bool goes_on = n > 0 && rings[n - 1].piece == rings[n].piece;
        if (is_steep && !goes_on) continue;
        frame.normal = scene::normal_towards(is_steep ? rings[n - 1].frame.normal : up, frame.tangent);
    }
}

bool has_rim(const ElementInput& input) { return input.element.halo_px > 0 && !look_of(input).is_mixed; }

bool has_margin(const ElementInput& input) {
    if (input.element.uncertainty != design::ElementUncertainty::widening) return false;
    if (input.element.technique == design::DataTechnique::space_time) return false;
    return states_accuracy(input.layer);
}

}  // namespace

bool shows_tubes(const scene::Layer& layer) { return layer.entry->shape == scene::LayerShape::lines; }

std::uint32_t TubeSolids::rings_for(std::uint32_t batch_vertices) {
    return std::clamp(batch_vertices / kBatchVerticesARing, kTubeBlockRings, kMaxRings);
}

std::uint64_t TubeSolids::bytes_needed(std::uint32_t rings) {
    return TubePath::bytes_needed() + TubeLine::bytes_needed(rings) + TubeSkin::bytes_needed() +
           std::uint64_t{with_cusps(rings)} * sizeof(scene::TubeRing) + kRingPadding_bytes;
}

bool TubeSolids::start(base::Arena& arena, std::uint32_t rings) {
    rings_ = arena.allocate_array<scene::TubeRing>(with_cusps(rings));
    return !rings_.empty() && way_.start(arena) && line_.start(arena, rings) && skin_.start(arena);
}

ElementCount TubeSolids::add(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    way_.plan(input, most_points(batch, input));
    const PlaceAccuracy worst = worst_accuracy(input.layer);
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        if (look_of_feature(input, feature).is_hidden) {
            count.hidden += input.layer.points_of(feature).count;
            continue;
        }
        way_.read(feature, line_);
        const scene::TubeCounts made = scene::make_tube(line_.points(), glm::dvec3(0), rings_);
        keep_upright({rings_.data(), made.rings});
        const Work work{batch, mesh, input, feature, {rings_.data(), made.rings}, worst};
        const std::uint32_t drawn = add_layer(work, Layer::sides);
        if (drawn > 0 && has_rim(input)) add_layer(work, Layer::rim);
        if (drawn > 0 && has_margin(input)) add_layer(work, Layer::margin);
        if (drawn > 0 && (input.element.link || way_.is_space_time())) add_posts(work);
        const std::uint32_t within = drawn > 0 ? line_.left_out + made.close_points : 0;
        count.drawn += drawn;
        count.aggregated += within;
        count.hidden += input.layer.points_of(feature).count - drawn - within;
    }
    return count;
}

std::uint32_t TubeSolids::most_points(const SolidBatch& batch, const ElementInput& input) const {
    std::size_t vertices = TubeSkin::kRingVertices, indices = kSideIndices;
    if (has_rim(input)) {
        vertices += kTubeRimSides;
        indices += kSideIndices;
    }
    if (has_margin(input)) {
        vertices += kTubeHullSides;
        indices += 6 * std::size_t{kTubeHullSides};
    }
    // Every line has two ends, and posts.
    const std::size_t ends = input.layer.entry->feature_count * std::size_t{4 * TubeSkin::kEndVertices};
    const std::size_t room = std::min(batch.vertices_left() / vertices, batch.indices_left() / indices) / kShareOfRoom;
    const std::size_t taken = ends / vertices;
    return static_cast<std::uint32_t>(std::min<std::size_t>(room - std::min(room, taken), line_.capacity()));
}

/// Returns how many points have a ring in it.
std::uint32_t TubeSolids::add_layer(const Work& work, Layer layer) {
    SolidLook look = look_of(work.input);
    if (layer == Layer::rim) {
        look = {};
        look.group = work.input.group;
        look.halo_px = static_cast<float>(work.input.element.halo_px);
    } else if (layer == Layer::margin) {
        look.opacity *= kMarginShare * static_cast<float>(work.input.element.uncertainty_strength);
        look.is_mixed = true;
        look.is_thing = look.has_grid = false;
    }
    look.is_hollow = true;  // it is not visible from inside
    look.near_m = kNearRadii * largest_radius_m(work, layer);
    work.batch.set_look(look, work.input.layer.entry->data_time_ns);
    std::uint32_t points = 0;
    std::int64_t last_source = -1;
    const base::Span<const scene::TubeRing>& rings = work.rings;
    for (std::size_t first = 0, end = 0; first < rings.size(); first = end) {
        end = first + 1;
        while (end < rings.size() && rings[end].piece == rings[first].piece && end - first < kTubeBlockRings) ++end;
        const bool begins = first == 0 || rings[first - 1].piece != rings[first].piece;
        const bool ends = end == rings.size() || rings[end].piece != rings[first].piece;
        const std::size_t from = begins ? first : first - 1;  // where the block before stopped
        if (!add_block(work, layer, {rings.subspan(from, end - from), begins, ends})) continue;
        for (std::size_t n = from; n < end; ++n) {
            points += rings[n].source > last_source ? 1 : 0;
            last_source = std::max<std::int64_t>(last_source, rings[n].source);
        }
    }
    return points;
}

bool TubeSolids::add_block(const Work& work, Layer layer, const TubeBlock& block) {
    std::array<RingColors, kTubeBlockRings + 1> colors;
    std::array<TubeMargin, kTubeBlockRings + 1> margins;
    const std::size_t count = block.rings.size();
    for (std::size_t n = 0; n < count; ++n) {
        colors[n] = layer == Layer::rim ? RingColors{kRimColor, kRimColor} : colors_of(work, block.rings[n]);
        if (layer == Layer::margin) margins[n] = margin_of(work, block.rings[n]);
    }
    if (block.rings[0].is_marker)
        return layer == Layer::sides && add_tube_marker(work.batch, work.mesh, block.rings[0], colors[0].even);
    switch (layer) {
        case Layer::sides: return skin_.add_sides(work.batch, work.mesh, block, {colors.data(), count});
        case Layer::rim: return add_tube_hull(work.batch, work.mesh, block, kTubeRimSides, {}, {colors.data(), count});
        case Layer::margin:
            return add_tube_hull(work.batch, work.mesh, block, kTubeHullSides, {margins.data(), count}, {colors.data(), count});
    }
    return false;
}

RingColors TubeSolids::colors_of(const Work& work, const scene::TubeRing& ring) const {
    const scene::PointOfFeature of{work.feature, line_.numbers()[ring.source]};
    const design::DataElement& element = work.input.element;
    const auto shown = [&](const design::ColorEncoding& encoding) {
        return TubeColor{encoded_color(work.input, encoding, of), encoded_uncertainty(work.input, encoding, of)};
    };
    const TubeColor even = shown(element.by_color);
    return {even, element.by_second_color.is_used() ? shown(element.by_second_color) : even};
}

TubeMargin TubeSolids::margin_of(const Work& work, const scene::TubeRing& ring) const {
    const scene::PointOfFeature of{work.feature, line_.numbers()[ring.source]};
    const PlaceAccuracy accuracy = cautious_accuracy(work.input.layer, of, work.worst);
    return {accuracy.level_m, accuracy.height_m};
}

float TubeSolids::largest_radius_m(const Work& work, Layer layer) const {
    double largest_m = 0;
    for (const scene::TubeRing& ring : work.rings) {
        const TubeMargin margin = layer == Layer::margin ? margin_of(work, ring) : TubeMargin{};
        largest_m = std::max(largest_m, static_cast<double>(ring.radius_m) + std::max(margin.horizontal_m, margin.vertical_m));
    }
    return static_cast<float>(largest_m);
}

void TubeSolids::add_posts(const Work& work) {
    work.batch.set_look(look_of(work.input), work.input.layer.entry->data_time_ns);
    add_post(work, work.rings[0]);
    if (work.rings.size() > 1) add_post(work, work.rings[work.rings.size() - 1]);
}

/// From the ground to the ring's middle; none where no ground is known.
void TubeSolids::add_post(const Work& work, const scene::TubeRing& ring) {
    const earth::Geodetic at = earth::from_ecef(ring.centre);
    const double ground_m = work.input.ground.height_m(at.latitude_rad, at.longitude_rad);
    if (!(ground_m < at.height.m)) return;
    const LocalAxes axes = local_axes(at.latitude_rad, at.longitude_rad);
    const glm::dvec3 foot = ring.centre - (at.height.m - ground_m) * axes.up;
    const double radius_m = kPostShare * static_cast<double>(ring.radius_m);
    const glm::dvec3 round[4] = {axes.east * radius_m, axes.north * radius_m, axes.east * -radius_m, axes.north * -radius_m};
    const TubeColor shown = colors_of(work, ring).even;
    work.mesh.begin(foot);
    work.mesh.set_color(shown.color, shown.uncertainty);
    for (std::size_t n = 0; n < 4; ++n) {
        const glm::dvec3 &a = round[n], &b = round[(n + 1) % 4];
        work.mesh.quad(foot + a, foot + b, ring.centre + b, ring.centre + a);
    }
    work.mesh.add_to(work.batch);
}

}  // namespace tedavis::draw
