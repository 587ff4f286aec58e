/// The stages of a traced picture as functions, called by the tasks of the token stream (trace_picture.hpp) or directly:
/// primary rays of tiles, shading of spans of 64 pixels, mirrored rays, supersampled pixels, conversion to display levels.
///
/// A pixel's result depends only on the scene, the settings of its region and the pixel, and is written by one call only. So
/// the picture does not depend on the order of calls or on threads. Any thread, after begin().
///
/// Memory  from an arena, at start: 29 bytes per pixel.
#pragma once

#include "render_core/raytrace/picture/display_levels.hpp"
#include "render_core/raytrace/picture/span_shader.hpp"
#include "render_core/raytrace/stream/task.hpp"
#include "render_core/raytrace/surface/pixel_footprint.hpp"

namespace tedavis::raytrace {

/// A reflected ray, with the light that its pixel has so far.
struct TEDAVIS_RECORD MirroredRay {
    std::uint32_t pixel, depth;
    std::uint32_t origin[6];  ///< three doubles
    float direction[3];
    float weight;    ///< weight of the light that it will collect
    float light[3];  ///< light collected before
};

/// The remaining work of a span.
struct SpanRemainder {
    std::uint32_t rays = 0, resampled = 0;
    MirroredRay ray[PixelSpan::kMax];
    std::uint32_t pixel[PixelSpan::kMax];
};

/// The settings of a picture's regions, which are also its tiles. Borrowed.
struct PictureVariants {
    static constexpr std::uint32_t kMax = 4;
    static constexpr std::uint32_t kRegionWidth = 64, kRegionHeight = 32;

    base::Span<const TraceSettings> settings;  ///< 1 to kMax
    base::Span<const std::uint8_t> regions;    ///< index into `settings`, row by row; empty: the first for all regions

    [[nodiscard]] static constexpr std::uint32_t regions_across(std::uint32_t width) {
        return (width + kRegionWidth - 1) / kRegionWidth;
    }
    [[nodiscard]] static constexpr std::uint32_t regions_down(std::uint32_t height) {
        return (height + kRegionHeight - 1) / kRegionHeight;
    }
};

template <class Height>
class TraceStages {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t width, std::uint32_t height);
    /// Allocates memory; returns false where the arena is too small.
    [[nodiscard]] bool start(std::uint32_t width, std::uint32_t height, base::Arena& arena);
    /// To be called before a picture. The scene has its view and was started for these settings; all arguments must stay valid
    /// until the picture is done. `rgb8` has three bytes per pixel, or is empty.
    void begin(const TracedScene<Height>& scene, const TraceLook& look, const PictureVariants& variants,
               base::Span<std::uint8_t> rgb8);

    [[nodiscard]] std::uint32_t tiles() const {
        return PictureVariants::regions_across(width_) * PictureVariants::regions_down(height_);
    }
    /// Number of spans in a tile. Spans are numbered tile by tile; some have no pixels.
    static constexpr std::uint32_t kSpansOfTile = PictureVariants::kRegionHeight;
    [[nodiscard]] PixelSpan span(std::uint32_t n) const;
    /// A pixel's index among the pixels of all spans, PixelSpan::kMax for each.
    [[nodiscard]] std::uint32_t place_of(std::uint32_t pixel) const;

    void trace_tile(std::uint32_t tile) const;
    /// Shades a span. Unfinished pixels are in `rest`; set_levels() skips them.
    void shade_span(const PixelSpan& span, SpanRemainder& rest) const;
    /// Follows up to PixelSpan::kMax rays. Rays whose pixels are still unfinished are written to `further`; returns their
    /// number.
    std::uint32_t follow(const MirroredRay* rays, std::uint32_t count, MirroredRay* further) const;
    void resample(std::uint32_t pixel) const;
    void set_levels(const PixelSpan& span) const;

    [[nodiscard]] bool has_remainders() const { return has_remainders_; }
    /// The picture in linear light, row by row.
    [[nodiscard]] base::Span<const glm::vec3> light() const { return {light_.data(), light_.size()}; }
    [[nodiscard]] const HitPicture& hits() const { return hits_; }
    /// Width of a pixel at t = 1 in posts, for view_regions().
    [[nodiscard]] double pixel_width_posts() const { return footprint_posts(1, pixel_width_m_, maps_.scale); }

private:
    struct Variant {
        const TraceSettings* settings = nullptr;
        const TracedTerrain* terrain = nullptr;
    };
    [[nodiscard]] PixelRect rect(std::uint32_t tile) const;
    [[nodiscard]] std::uint32_t variant_at(std::uint32_t x, std::uint32_t y) const;
    [[nodiscard]] SpanShader<Height> shader(std::uint32_t variant) const;
    [[nodiscard]] MirroredRay mirrored_at(const SpanShader<Height>& shader, const SpanRays& rays, const SpanSurface& surface,
                                          std::uint32_t n) const;

    std::uint32_t width_ = 0, height_ = 0;
    bool has_remainders_ = false;
    const TraceLook* look_ = nullptr;
    ShadingMaps<Height> maps_;
    GridCamera camera_;
    double pixel_width_m_ = 0;
    PictureVariants variants_;
    Variant variant_[PictureVariants::kMax];
    base::Span<std::uint8_t> rgb8_;
    HitPicture hits_;
    base::Span<glm::vec3> light_;  ///< red below 0: unfinished
    DisplayLevels levels_;
};

}  // namespace tedavis::raytrace
