#include "render_core/raytrace/picture/span_light.hpp"

#include <cmath>

#include "render_core/raytrace/picture/wide_loops.hpp"
#include "render_core/raytrace/shading/aperture_light.hpp"
#include "render_core/raytrace/shading/arc_functions.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kMaxOfSpan = PixelSpan::kMax;

float cut_to_one(float x) { return std::min(std::max(x, 0.0f), 1.0f); }

/// The angle whose cosine is 1 - `versine`, 0..pi: small angles keep their digits (Abramowitz and Stegun 1964, 4.4.46).
float arc_of_versine(float versine) {
    const float least = std::min(versine, 2 - versine), x = 1 - least;
    float sum = -0.0012624911f;
    sum = sum * x + 0.0066700901f;
    sum = sum * x - 0.0170881256f;
    sum = sum * x + 0.0308918810f;
    sum = sum * x - 0.0501743046f;
    sum = sum * x + 0.0889789874f;
    sum = sum * x - 0.2145988016f;
    sum = sum * x + 1.5707963050f;
    const float angle = std::sqrt(std::max(least, 0.0f)) * sum;
    return versine > 1 ? static_cast<float>(kArcPi) - angle : angle;
}

/// Posts round places of a span, with weights.
struct SpanPosts {
    std::uint32_t first[kMaxOfSpan];
    float weight[4][kMaxOfSpan];
};

TEDAVIS_WIDE_LOOPS void find_posts(const SpanSurface& surface, std::uint32_t columns, std::uint32_t rows, SpanPosts& posts) {
    const double most_x = columns - 1.0, most_y = rows - 1.0;
    const auto last_column = static_cast<std::int32_t>(columns - 2), last_row = static_cast<std::int32_t>(rows - 2);
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        const double x = std::min(std::max(surface.x[n], 0.0), most_x), y = std::min(std::max(surface.y[n], 0.0), most_y);
        const std::int32_t column = std::min(static_cast<std::int32_t>(x), last_column);
        const std::int32_t row = std::min(static_cast<std::int32_t>(y), last_row);
        const auto u = static_cast<float>(x - column), v = static_cast<float>(y - row);
        posts.first[n] = static_cast<std::uint32_t>(row) * columns + static_cast<std::uint32_t>(column);
        posts.weight[0][n] = (1 - u) * (1 - v);
        posts.weight[1][n] = u * (1 - v);
        posts.weight[2][n] = (1 - u) * v;
        posts.weight[3][n] = u * v;
    }
}

/// Mean apertures: axes and cosines of their radii.
struct SpanApertures {
    SpanVectors axis;
    float cos_radius[kMaxOfSpan];
};

/// Of the four posts round each place: x, y and cos_radius in 16 bits each, from the lowest on.
struct SpanStored {
    std::uint64_t post[4][kMaxOfSpan];
};

std::uint64_t packed_of(std::uint16_t x, std::uint16_t y, std::uint16_t cosine) {
    return x | std::uint64_t{y} << 16 | std::uint64_t{cosine} << 32;
}

template <class Height>
void read_apertures(const SkyMap<Height>& sky, const SpanPosts& posts, std::uint32_t count, SpanStored& read) {
    const auto* const stored = sky.stored_apertures().data();
    const std::uint32_t offset[4] = {0, 1, sky.columns(), sky.columns() + 1};
    for (int k = 0; k < 4; ++k)
        for (std::uint32_t n = 0; n < count; ++n) {
            const auto& one = stored[posts.first[n] + offset[k]];
            read.post[k][n] = packed_of(static_cast<std::uint16_t>(one.x), static_cast<std::uint16_t>(one.y), one.cos_radius);
        }
}

float of_16_bits(std::uint64_t packed) { return static_cast<float>(static_cast<std::int16_t>(packed & 0xffff)); }

TEDAVIS_WIDE_LOOPS void find_apertures(const SpanStored& __restrict read, const SpanPosts& __restrict posts, std::uint32_t count,
                                       SpanApertures& __restrict apertures) {
    float x[kMaxOfSpan] = {}, y[kMaxOfSpan] = {}, z[kMaxOfSpan] = {}, sum[kMaxOfSpan] = {};
    for (int k = 0; k < 4; ++k)
        for (std::uint32_t n = 0; n < count; ++n) {
            const std::uint64_t post = read.post[k][n];
            const float a = of_16_bits(post) * (1 / 32767.0f), b = of_16_bits(post >> 16) * (1 / 32767.0f);
            const float w = posts.weight[k][n];
            x[n] += w * a;
            y[n] += w * b;
            z[n] += w * std::sqrt(std::max(1 - a * a - b * b, 0.0f));
            sum[n] += w * static_cast<float>(static_cast<std::int32_t>(post >> 32));
        }
    for (std::uint32_t n = 0; n < count; ++n) {
        const float length = std::sqrt(x[n] * x[n] + y[n] * y[n] + z[n] * z[n]), whole = 1 / std::max(length, 1e-6f);
        apertures.axis.of[0][n] = x[n] * whole;
        apertures.axis.of[1][n] = y[n] * whole;
        apertures.axis.of[2][n] = z[n] * whole;
        apertures.cos_radius[n] = std::min(sum[n] * (1 / 65535.0f), 1.0f);
    }
}

/// aperture_light() with OverlapKind::smooth and the sun's own size.
TEDAVIS_WIDE_LOOPS void light_through(const SpanApertures& apertures, const glm::dvec3& towards_sun, std::uint32_t count,
                                      SpanLight& light) {
    const glm::vec3 sun(towards_sun);
    const auto sun_radius = static_cast<float>(kSunRadius_rad);
    const auto half = static_cast<float>(direction_of_angle(kSunRadius_rad / 2).y);
    const float sun_versine = 2 * half * half;
    for (std::uint32_t n = 0; n < count; ++n) {
        const float x = apertures.axis.of[0][n], y = apertures.axis.of[1][n], z = apertures.axis.of[2][n];
        const float cosine = apertures.cos_radius[n], versine = 1 - cosine;
        const float facing = light.normal.of[0][n] * x + light.normal.of[1][n] * y + light.normal.of[2][n] * z;
        light.sky_seen[n] = cut_to_one(facing) * (1 - cosine * cosine);
        const float dx = x - sun.x, dy = y - sun.y, dz = z - sun.z;
        const float radius = arc_of_versine(versine), distance = arc_of_versine((dx * dx + dy * dy + dz * dz) / 2);
        const float smaller = std::min(radius, sun_radius), larger = std::max(radius, sun_radius);
        const float share = cut_to_one(1 - (distance - (larger - smaller)) / (2 * std::max(smaller, 1e-6f)));
        const float size = std::min(versine / sun_versine, 1.0f);
        light.sun_seen[n] *= size * (share * share * (3 - 2 * share));
    }
}

/// Which two colours a height lies between, and how far.
TEDAVIS_WIDE_LOOPS void place_in_palette(const SpanSurface& surface, const GroundColors& ground, std::int32_t* first,
                                         float* share) {
    const auto parts = static_cast<float>(ground.palette.size() - 1);
    const float lowest = ground.lowest, scale = parts / (ground.highest - lowest);
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        const float place = std::min(std::max((surface.height[n] - lowest) * scale, 0.0f), parts);
        first[n] = static_cast<std::int32_t>(place);
        share[n] = place - static_cast<float>(first[n]);
    }
}

}  // namespace

TEDAVIS_WIDE_LOOPS void find_normals(const SpanSurface& surface, const GridScale& scale, SpanVectors& normals) {
    const auto by_x = static_cast<float>(scale.height_m / scale.column_m),
               by_y = static_cast<float>(scale.height_m / scale.row_m);
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        const float x = -surface.slope_x[n] * by_x, y = -surface.slope_y[n] * by_y, z = 1 / std::sqrt(x * x + y * y + 1);
        normals.of[0][n] = x * z;
        normals.of[1][n] = y * z;
        normals.of[2][n] = z;
    }
}

TEDAVIS_WIDE_LOOPS void find_eyes(const float* direction_x, const float* direction_y, const float* direction_z,
                                  std::uint32_t count, const GridScale& scale, SpanVectors& eyes) {
    const auto column = static_cast<float>(scale.column_m), row = static_cast<float>(scale.row_m),
               step = static_cast<float>(scale.height_m);
    for (std::uint32_t n = 0; n < count; ++n) {
        const float x = -direction_x[n] * column, y = -direction_y[n] * row, z = -direction_z[n] * step;
        const float whole = 1 / std::sqrt(x * x + y * y + z * z);
        eyes.of[0][n] = x * whole;
        eyes.of[1][n] = y * whole;
        eyes.of[2][n] = z * whole;
    }
}

void find_colors(const SpanSurface& surface, const TraceLook& look, float (&color)[3][PixelSpan::kMax]) {
    const base::Span<const glm::vec3> palette = look.ground.palette;
    if (palette.empty()) {
        for (int c = 0; c < 3; ++c) std::fill_n(color[c], surface.count, look.material.color[c]);
        return;
    }
    std::int32_t first[kMaxOfSpan];
    float share[kMaxOfSpan];
    place_in_palette(surface, look.ground, first, share);
    const glm::vec3* const colors = palette.data();
    const auto last = static_cast<std::int32_t>(palette.size() - 1);
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        const glm::vec3 &low = colors[first[n]], &high = colors[std::min(first[n] + 1, last)];
        for (int c = 0; c < 3; ++c) color[c][n] = low[c] * (1 - share[n]) + high[c] * share[n];
    }
}

template <class Height>
void find_sky(const SpanSurface& surface, const SkyMap<Height>& sky, Ambient ambient, const glm::dvec3& towards_sun,
              SpanLight& light) {
    SpanPosts posts;
    find_posts(surface, sky.columns(), sky.rows(), posts);
    if (ambient == Ambient::apertures) {
        SpanStored read;
        SpanApertures apertures;
        read_apertures(sky, posts, surface.count, read);
        find_apertures(read, posts, surface.count, apertures);
        return light_through(apertures, towards_sun, surface.count, light);
    }
    const std::uint8_t* const views = sky.stored_views().data();
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        const std::uint8_t* const first = views + posts.first[n];
        light.sky_seen[n] = (posts.weight[0][n] * first[0] + posts.weight[1][n] * first[1] +
                             posts.weight[2][n] * first[sky.columns()] + posts.weight[3][n] * first[sky.columns() + 1]) *
                            (1 / 255.0f);
    }
}

TEDAVIS_WIDE_LOOPS void add_up_light(Shading shading, const TraceLook& look, std::uint32_t count, SpanLight& light) {
    const glm::vec3 sun(look.sun.towards);
    float diffuse[kMaxOfSpan], highlight[kMaxOfSpan];
    for (std::uint32_t n = 0; n < count; ++n) {
        const float cosine = light.normal.of[0][n] * sun.x + light.normal.of[1][n] * sun.y + light.normal.of[2][n] * sun.z;
        diffuse[n] = std::max(cosine, 0.0f);
        highlight[n] = 0;
    }
    if (shading == Shading::phong && look.material.gloss > 0) {
        for (std::uint32_t n = 0; n < count; ++n) {
            const float twice = 2 * diffuse[n];
            const float along = (twice * light.normal.of[0][n] - sun.x) * light.eye.of[0][n] +
                                (twice * light.normal.of[1][n] - sun.y) * light.eye.of[1][n] +
                                (twice * light.normal.of[2][n] - sun.z) * light.eye.of[2][n];
            highlight[n] = diffuse[n] > 0 ? cut_to_one(along) : 0;
        }
        float power[kMaxOfSpan];
        for (std::uint32_t n = 0; n < count; ++n) power[n] = highlight[n] > 0 ? 1.0f : 0.0f;
        for (std::uint32_t exponent = look.material.sharpness; exponent != 0; exponent >>= 1) {
            if ((exponent & 1) != 0)
                for (std::uint32_t n = 0; n < count; ++n) power[n] *= highlight[n];
            for (std::uint32_t n = 0; n < count; ++n) highlight[n] *= highlight[n];
        }
        for (std::uint32_t n = 0; n < count; ++n) highlight[n] = power[n] * look.material.gloss * light.sun_seen[n];
    }
    if (shading == Shading::none) {
        for (int c = 0; c < 3; ++c)
            for (std::uint32_t n = 0; n < count; ++n) light.light[c][n] = light.color[c][n];
        return;
    }
    for (int c = 0; c < 3; ++c) {
        const float radiance = look.sun.radiance[c], sky = look.sky[c];
        for (std::uint32_t n = 0; n < count; ++n)
            light.light[c][n] = light.color[c][n] * (sky * light.sky_seen[n] + radiance * (light.sun_seen[n] * diffuse[n])) +
                                radiance * highlight[n];
    }
}

template void find_sky(const SpanSurface&, const SkyMap<std::int16_t>&, Ambient, const glm::dvec3&, SpanLight&);
template void find_sky(const SpanSurface&, const SkyMap<float>&, Ambient, const glm::dvec3&, SpanLight&);

}  // namespace tedavis::raytrace
