/// The stages of a traced picture as functions, called by the tasks of the token stream (trace_picture.hpp) or directly: tiles of
/// primary rays, spans of 64 pixels to be shaded, mirrored rays, pixels that need more rays, levels of the display.
///
/// A pixel's result depends on the scene, the settings of its region and the pixel alone; each is written by one call only. So
/// the picture is the same however calls are ordered or shared out. Any thread, once begun.
///
/// Memory  an arena's, at start: 29 bytes a pixel.
#pragma once

#include "render_core/raytrace/picture/display_levels.hpp"
#include "render_core/raytrace/picture/span_shader.hpp"
#include "render_core/raytrace/stream/task.hpp"
#include "render_core/raytrace/surface/pixel_footprint.hpp"

namespace tedavis::raytrace {

/// A ray that a mirror sent on, with what its pixel has so far.
struct TEDAVIS_RECORD MirroredRay {
    std::uint32_t pixel, depth;
    std::uint32_t origin[6];  ///< three doubles
    float direction[3];
    float weight;    ///< of what it will see
    float light[3];  ///< of what was seen before
};

/// What a span has left to do.
struct SpanRemainder {
    std::uint32_t rays = 0, resampled = 0;
    MirroredRay ray[PixelSpan::kMax];
    std::uint32_t pixel[PixelSpan::kMax];
};

/// Settings of a picture's regions, which are also its tiles: which of `settings` each has. Borrowed.
struct PictureVariants {
    static constexpr std::uint32_t kMax = 4;
    static constexpr std::uint32_t kRegionWidth = 64, kRegionHeight = 32;

    base::Span<const TraceSettings> settings;  ///< 1 to kMax
    base::Span<const std::uint8_t> regions;    ///< row by row; empty: the first everywhere

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
    /// False where the arena has no room.
    [[nodiscard]] bool start(std::uint32_t width, std::uint32_t height, base::Arena& arena);
    /// Before a picture. The scene has its view, and was started for these settings; all is borrowed until the picture is done.
    /// `rgb8` has three bytes a pixel, or is empty.
    void begin(const TracedScene<Height>& scene, const TraceLook& look, const PictureVariants& variants,
               base::Span<std::uint8_t> rgb8);

    [[nodiscard]] std::uint32_t tiles() const {
        return PictureVariants::regions_across(width_) * PictureVariants::regions_down(height_);
    }
    /// Spans are numbered tile by tile, so many in each; some have no pixels.
    static constexpr std::uint32_t kSpansOfTile = PictureVariants::kRegionHeight;
    [[nodiscard]] PixelSpan span(std::uint32_t n) const;
    /// A pixel's number among the places of all spans, PixelSpan::kMax for each.
    [[nodiscard]] std::uint32_t place_of(std::uint32_t pixel) const;

    void trace_tile(std::uint32_t tile) const;
    /// Pixels that are not done yet are in `rest`; set_levels() leaves them out.
    void shade_span(const PixelSpan& span, SpanRemainder& rest) const;
    /// Up to PixelSpan::kMax rays. Those whose pixels are not done come back, to the front of `further`; returns their number.
    std::uint32_t follow(const MirroredRay* rays, std::uint32_t count, MirroredRay* further) const;
    void resample(std::uint32_t pixel) const;
    void set_levels(const PixelSpan& span) const;

    [[nodiscard]] bool has_remainders() const { return has_remainders_; }
    /// Linear light, row by row.
    [[nodiscard]] base::Span<const glm::vec3> light() const { return {light_.data(), light_.size()}; }
    [[nodiscard]] const HitPicture& hits() const { return hits_; }
    /// What a pixel covers where t is 1, for view_regions().
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
    base::Span<glm::vec3> light_;  ///< red below 0: not done
    DisplayLevels levels_;
};

}  // namespace tedavis::raytrace
