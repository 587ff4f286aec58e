#include "render_core/raytrace/picture/trace_stages.hpp"

#include <algorithm>
#include <cstring>

#include "render_core/raytrace/picture/wide_loops.hpp"
#include "render_core/raytrace/surface/pixel_footprint.hpp"

namespace tedavis::raytrace {
namespace {

constexpr glm::vec3 kNotDone(-1, 0, 0);

/// Of a camera's rays through (x, y), in pixels from the upper left.
void set_direction(const GridCamera& camera, float x, float y, SpanRays& rays, std::uint32_t n) {
    for (int axis = 0; axis < 3; ++axis)
        rays.direction[axis][n] = camera.corner[axis] + camera.right[axis] * x + camera.down[axis] * y;
}

/// Of pixels of a line from (x, y) on; what set_direction() gives for their middles.
TEDAVIS_WIDE_LOOPS void set_directions(const GridCamera& camera, std::uint32_t x, std::uint32_t y, std::uint32_t count,
                                       SpanRays& rays) {
    const float down = static_cast<float>(y) + 0.5f;
    const auto first = static_cast<std::int32_t>(x);
    for (int axis = 0; axis < 3; ++axis) {
        const float corner = camera.corner[axis], right = camera.right[axis], fall = camera.down[axis] * down;
        for (std::uint32_t n = 0; n < count; ++n)
            rays.direction[axis][n] = corner + right * (static_cast<float>(first + static_cast<std::int32_t>(n)) + 0.5f) + fall;
    }
}

void set_hit(const RayHit& hit, SpanSurface& surface, std::uint32_t n) {
    surface.is_hit[n] = hit.is_hit;
    surface.x[n] = hit.x;
    surface.y[n] = hit.y;
    surface.t[n] = hit.t;
    surface.height[n] = static_cast<float>(hit.point.height);
    surface.slope_x[n] = static_cast<float>(hit.point.slope_x);
    surface.slope_y[n] = static_cast<float>(hit.point.slope_y);
}

}  // namespace

template <class Height>
std::uint64_t TraceStages<Height>::bytes_needed(std::uint32_t width, std::uint32_t height) {
    const std::uint64_t pixels = std::uint64_t{width} * height;
    return pixels * (sizeof(float) + sizeof(std::int32_t) + sizeof(HitSide) + 2 * sizeof(float) + sizeof(glm::vec3)) +
           DisplayLevels::kEntries + 64;
}

template <class Height>
bool TraceStages<Height>::start(std::uint32_t width, std::uint32_t height, base::Arena& arena) {
    TEDAVIS_CHECK(width > 0 && height > 0);
    width_ = width;
    height_ = height;
    const std::size_t pixels = std::size_t{width} * height;
    hits_.t = arena.allocate_array<float>(pixels);
    hits_.cell = arena.allocate_array<std::int32_t>(pixels);
    hits_.u = arena.allocate_array<float>(pixels);
    hits_.v = arena.allocate_array<float>(pixels);
    light_ = arena.allocate_array<glm::vec3>(pixels);
    hits_.side = arena.allocate_array<HitSide>(pixels);
    return levels_.start(arena) && !hits_.u.empty() && !hits_.v.empty() && !hits_.side.empty() && !light_.empty();
}

template <class Height>
void TraceStages<Height>::begin(const TracedScene<Height>& scene, const TraceLook& look, const PictureVariants& variants,
                                base::Span<std::uint8_t> rgb8) {
    const std::size_t pixels = light_.size();
    TEDAVIS_CHECK(scene.size().width == width_ && scene.size().height == height_);
    TEDAVIS_CHECK(!variants.settings.empty() && variants.settings.size() <= PictureVariants::kMax);
    TEDAVIS_CHECK(variants.regions.empty() || variants.regions.size() == tiles());
    TEDAVIS_CHECK(rgb8.empty() || rgb8.size() == 3 * pixels);
    look_ = &look;
    maps_ = scene.maps();
    camera_ = scene.sight().camera;
    variants_ = variants;
    rgb8_ = rgb8;
    const glm::dvec3 right(camera_.right);
    pixel_width_m_ =
        glm::length(glm::dvec3(right.x * maps_.scale.column_m, right.y * maps_.scale.row_m, right.z * maps_.scale.height_m));
    has_remainders_ = false;
    for (std::uint32_t n = 0; n < variants.settings.size(); ++n) {
        const TraceSettings& settings = variants.settings[n];
        variant_[n] = {&settings, &scene.terrain(settings)};
        has_remainders_ = has_remainders_ || settings.mirrors > 0 || settings.antialiasing == Antialiasing::supersampling;
    }
}

template <class Height>
PixelRect TraceStages<Height>::rect(std::uint32_t tile) const {
    constexpr std::uint32_t kWidth = PictureVariants::kRegionWidth, kHeight = PictureVariants::kRegionHeight;
    const std::uint32_t across = PictureVariants::regions_across(width_);
    const std::uint32_t x = tile % across * kWidth, y = tile / across * kHeight;
    return {x, y, std::min(kWidth, width_ - x), std::min(kHeight, height_ - y)};
}

template <class Height>
PixelSpan TraceStages<Height>::span(std::uint32_t n) const {
    const std::uint32_t tile = n / kSpansOfTile, line = n % kSpansOfTile;
    const PixelRect all = rect(tile);
    if (line >= all.height) return {};
    return {(all.y + line) * width_ + all.x, all.width};
}

template <class Height>
std::uint32_t TraceStages<Height>::place_of(std::uint32_t pixel) const {
    constexpr std::uint32_t kWidth = PictureVariants::kRegionWidth, kHeight = PictureVariants::kRegionHeight;
    const std::uint32_t y = pixel / width_, x = pixel - y * width_, column = x / kWidth;
    const std::uint32_t tile = y / kHeight * PictureVariants::regions_across(width_) + column;
    return (tile * kSpansOfTile + y % kHeight) * PixelSpan::kMax + x % kWidth;
}

template <class Height>
std::uint32_t TraceStages<Height>::variant_at(std::uint32_t x, std::uint32_t y) const {
    if (variants_.regions.empty()) return 0;
    const std::uint32_t across = PictureVariants::regions_across(width_);
    return variants_.regions[std::size_t{y / PictureVariants::kRegionHeight} * across + x / PictureVariants::kRegionWidth];
}

template <class Height>
SpanShader<Height> TraceStages<Height>::shader(std::uint32_t variant) const {
    return {variant_[variant].settings, variant_[variant].terrain, maps_, look_, pixel_width_m_};
}

template <class Height>
void TraceStages<Height>::trace_tile(std::uint32_t tile) const {
    const PixelRect all = rect(tile);
    variant_[variant_at(all.x, all.y)].terrain->trace(all, hits_);
}

template <class Height>
MirroredRay TraceStages<Height>::mirrored_at(const SpanShader<Height>& shader, const SpanRays& rays, const SpanSurface& surface,
                                             std::uint32_t n) const {
    const Ray ray = shader.mirrored(rays, surface, n);
    MirroredRay sent = {};
    std::memcpy(sent.origin, &ray.origin, sizeof sent.origin);
    std::memcpy(sent.direction, &ray.direction, sizeof sent.direction);
    return sent;
}

template <class Height>
void TraceStages<Height>::shade_span(const PixelSpan& span, SpanRemainder& rest) const {
    rest.rays = rest.resampled = 0;
    const std::uint32_t y = span.first / width_, x = span.first - y * width_;
    const SpanShader<Height> shader = this->shader(variant_at(x, y));
    const TraceSettings& settings = *shader.settings;
    SpanSurface surface;
    shader.terrain->find_surface(span, hits_, surface);
    SpanRays rays;
    rays.origin = camera_.origin;
    std::uint32_t seeds[PixelSpan::kMax];
    set_directions(camera_, x, y, span.count, rays);
    for (std::uint32_t n = 0; n < span.count; ++n) seeds[n] = span.first + n;
    glm::vec3* const light = light_.data() + span.first;
    shader.shade(rays, seeds, surface, light);
    if (settings.antialiasing == Antialiasing::supersampling)
        for (std::uint32_t n = 0; n < span.count; ++n) {
            if (!surface.is_hit[n] || rays_along_pixel(shader.footprint(surface.t[n]), settings.rays_along) == 1) continue;
            rest.pixel[rest.resampled++] = span.first + n;
            light[n] = kNotDone;
        }
    if (settings.mirrors == 0) return;
    for (std::uint32_t n = 0; n < span.count; ++n) {
        const float mirror = shader.mirror_of(surface, n);
        if (mirror <= 0 || light[n].x < 0) continue;
        MirroredRay& sent = rest.ray[rest.rays++] = mirrored_at(shader, rays, surface, n);
        sent.pixel = span.first + n;
        sent.depth = 1;
        sent.weight = mirror;
        for (int c = 0; c < 3; ++c) sent.light[c] = (1 - mirror) * light[n][c];
        light[n] = kNotDone;
    }
}

template <class Height>
std::uint32_t TraceStages<Height>::follow(const MirroredRay* rays, std::uint32_t count, MirroredRay* further) const {
    TEDAVIS_CHECK(count <= PixelSpan::kMax);
    std::uint32_t left = 0;
    for (std::uint32_t n = 0; n < count; ++n) {  // one by one: neighbours may be of other settings
        const MirroredRay sent = rays[n];
        const std::uint32_t y = sent.pixel / width_, x = sent.pixel - y * width_;
        const SpanShader<Height> shader = this->shader(variant_at(x, y));
        SpanRays one;
        std::memcpy(&one.origin, sent.origin, sizeof sent.origin);
        for (int axis = 0; axis < 3; ++axis) one.direction[axis][0] = sent.direction[axis];
        SpanSurface surface;
        surface.count = 1;
        set_hit(shader.terrain->intersect(one.ray(0)), surface, 0);
        glm::vec3 seen(0);
        SpanShader<Height> plain = shader;
        plain.pixel_width_m = 0;  // what a mirrored pixel covers is not known
        plain.shade(one, &sent.pixel, surface, &seen);
        const float mirror = sent.depth < shader.settings->mirrors ? shader.mirror_of(surface, 0) : 0;
        const glm::vec3 before(sent.light[0], sent.light[1], sent.light[2]), light = before + sent.weight * (1 - mirror) * seen;
        if (mirror <= 0) {
            light_.data()[sent.pixel] = light;
            continue;
        }
        MirroredRay& next = further[left++] = mirrored_at(shader, one, surface, 0);
        next.pixel = sent.pixel;
        next.depth = sent.depth + 1;
        next.weight = sent.weight * mirror;
        for (int c = 0; c < 3; ++c) next.light[c] = light[c];
    }
    return left;
}

template <class Height>
void TraceStages<Height>::resample(std::uint32_t pixel) const {
    const std::uint32_t y = pixel / width_, x = pixel - y * width_;
    const SpanShader<Height> shader = this->shader(variant_at(x, y));
    const std::uint32_t along = rays_along_pixel(shader.footprint(hits_.t.data()[pixel]), shader.settings->rays_along);
    SpanRays rays;
    rays.origin = camera_.origin;
    SpanSurface surface;
    surface.count = along * along;
    std::uint32_t seeds[PixelSpan::kMax];
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        const float part = 1 / static_cast<float>(along);
        const std::uint32_t line = n / along, column = n - line * along;
        const float right = (static_cast<float>(column) + 0.5f) * part, down = (static_cast<float>(line) + 0.5f) * part;
        set_direction(camera_, static_cast<float>(x) + right, static_cast<float>(y) + down, rays, n);
        set_hit(shader.terrain->intersect(rays.ray(n)), surface, n);
        seeds[n] = pixel * (TraceSettings::kMaxRaysAlong * TraceSettings::kMaxRaysAlong) + n;
    }
    glm::vec3 light[PixelSpan::kMax], sum(0);
    shader.shade(rays, seeds, surface, light);
    for (std::uint32_t n = 0; n < surface.count; ++n) sum += light[n];
    light_.data()[pixel] = sum / static_cast<float>(surface.count);
}

template <class Height>
void TraceStages<Height>::set_levels(const PixelSpan& span) const {
    if (rgb8_.empty()) return;
    const glm::vec3* const light = light_.data() + span.first;
    std::uint8_t* const rgb = rgb8_.data() + 3 * std::size_t{span.first};
    if (span.count == 0) return;
    if (!has_remainders_) return levels_.set(&light[0].x, 3 * span.count, rgb);
    for (std::uint32_t n = 0; n < span.count; ++n)
        if (light[n].x >= 0) levels_.set(&light[n].x, 3, rgb + 3 * n);
}

template class TraceStages<std::int16_t>;
template class TraceStages<float>;

}  // namespace tedavis::raytrace
