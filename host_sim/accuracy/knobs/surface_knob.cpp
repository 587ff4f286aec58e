#include "host_sim/accuracy/knobs/surface_knob.hpp"

#include <cmath>
#include <cstdio>
#include <optional>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/raytrace/search/trace_surface.hpp"

namespace tedavis::host_sim {
namespace {

using raytrace::SurfaceKind;
using raytrace::SurfaceSettings;

struct SurfaceLevel {
    const char* name;
    double amount;
    SurfaceSettings settings;
};

SurfaceSettings settings_of(SurfaceKind kind, std::uint32_t subdivisions = 1) {
    SurfaceSettings settings;
    settings.kind = kind;
    settings.subdivisions = subdivisions;
    return settings;
}

const std::vector<SurfaceLevel>& surface_levels() {
    static const std::vector<SurfaceLevel> kLevels = {
        {"bilinear", 1, settings_of(SurfaceKind::bilinear)},
        {"bicubic, 2 subdivisions", 2, settings_of(SurfaceKind::approximate_bicubic, 2)},
        {"bicubic, 4 subdivisions", 4, settings_of(SurfaceKind::approximate_bicubic, 4)},
        {"bicubic, 8 subdivisions", 8, settings_of(SurfaceKind::approximate_bicubic, 8)},
        {"bicubic, 16 subdivisions", 16, settings_of(SurfaceKind::approximate_bicubic, 16)},
        {"bicubic", 0, settings_of(SurfaceKind::bicubic)}};
    return kLevels;
}

constexpr std::size_t kRaysOfPart = 64, kPlacesOfPart = 256, kParts = 32, kFewParts = 4, kTriesOfPlace = 100;

KnobFacts surface_facts() {
    std::vector<KnobLevel> levels;
    for (const SurfaceLevel& level : surface_levels()) levels.push_back({level.name, level.amount});
    return {"smooth_surface",
            "Surface between the posts that rays meet",
            "surface of `tedavis trace` presets: raytrace::SurfaceSettings",
            "difference in height from the smooth surface",
            "m",
            {"the bicubic surface with Catmull-Rom slopes at the same place", 1e-9,
             "a polynomial of the sixteen posts, in doubles; heights below 9000 m have 12 digits behind the point of a metre"},
            "GDAL's cubic resampling (NUMERICS K3)",
            "Terrain alerts and the heights that the display states come from the database's own triangles.",
            "subdivisions of a cell in each direction",
            ExpectedLaw{-2, 0.3, "NUMERICS K3: subdivisions^-2"},
            std::move(levels)};
}

struct Place {
    double x, y;
};

class SurfaceKnob final : public Knob {
public:
    explicit SurfaceKnob(const KnobGround& ground)
        : Knob(surface_facts()), square_(ground.ground), samples_(ground.is_quick ? kFewParts : kParts) {
        for (const SurfaceLevel& level : surface_levels())
            surfaces_.push_back(std::make_unique<BoundedSurface>(square_, level.settings));
        rays_ = rays_over(square_, kRaysOfPart * samples_, 2);
        choose_places(kPlacesOfPart * samples_);
    }

    [[nodiscard]] std::size_t samples() const override { return samples_; }
    void run(std::size_t level, std::size_t sample) override {
        const BoundedSurface& surface = *surfaces_[level];
        for (std::size_t n = 0; n < kRaysOfPart; ++n)
            found_ += trace_surface(surface.maxima(), surface.settings(), rays_[sample * kRaysOfPart + n]).height;
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = 0; n < kPlacesOfPart; ++n) {
            const Place& place = places_[sample * kPlacesOfPart + n];
            errors.push_back(std::abs(height_m(level, place).value() - height_m(surfaces_.size() - 1, place).value()));
        }
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        const Place place = places_[sample * kPlacesOfPart + error];
        char text[80];
        std::snprintf(text, sizeof text, "column %.3f, row %.3f of the measured square", place.x, place.y);
        return text;
    }
    [[nodiscard]] std::uint64_t bytes(std::size_t level) const override { return surfaces_[level]->bytes(); }
    [[nodiscard]] double build_ms(std::size_t level) const override { return surfaces_[level]->build_ms(); }

private:
    /// Nothing where the surface has a hole.
    [[nodiscard]] std::optional<double> height_m(std::size_t level, const Place& place) const {
        raytrace::SurfacePoint point;
        if (!find_surface(square_.grid(), surfaces_[level]->settings(), place.x, place.y, point)) return std::nullopt;
        return point.height;
    }
    /// Where every level has a surface.
    void choose_places(std::size_t count) {
        SeededRandom numbers(3);
        for (std::size_t tries = 0; places_.size() < count && tries < kTriesOfPlace * count; ++tries) {
            const Place place = {numbers.between(0, square_.grid().columns - 1.0), numbers.between(0, square_.grid().rows - 1.0)};
            bool is_there = true;
            for (std::size_t level = 0; level < surfaces_.size(); ++level) is_there = is_there && height_m(level, place);
            if (is_there) places_.push_back(place);
        }
        if (places_.size() < count) throw UserError("the terrain has too few heights; name another --terrain");
    }

    TracedSquare square_;
    std::size_t samples_;
    std::vector<std::unique_ptr<BoundedSurface>> surfaces_;
    std::vector<raytrace::Ray> rays_;
    std::vector<Place> places_;
    double found_ = 0;  ///< so that no compiler leaves the tracing out
};

}  // namespace

std::unique_ptr<Knob> make_surface_knob(const KnobGround& ground) { return std::make_unique<SurfaceKnob>(ground); }

}  // namespace tedavis::host_sim
