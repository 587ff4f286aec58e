#include "host_sim/accuracy/knobs/sky_knobs.hpp"

#include <cmath>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/raytrace/shading/sky_map.hpp"

namespace tedavis::host_sim {
namespace {

using raytrace::SkyMapSettings;

constexpr std::uint32_t kAzimuths[] = {4, 8, 16, 32, 64, 128};
constexpr std::uint32_t kRadii[] = {8, 16, 32, 64, 128, 256};
constexpr std::uint32_t kManyAzimuths = 2048;
constexpr std::size_t kPostsOfSample = 32, kSkySamples = 64, kQuickSkySamples = 6;
constexpr std::size_t kTriesOfPost = 100;

constexpr const char* kSkyNeverTrades = "Cast shadows are rays at every level; only the light of the sky changes.";
constexpr const char* kSkySetting = "raytrace::SceneSize of pictures with `ambient = sky_view` or `apertures`: ";

SkyMapSettings sky_settings(std::uint32_t azimuths, std::uint32_t radius) {
    SkyMapSettings settings;
    settings.azimuths = azimuths;
    settings.radius = radius;
    return settings;
}

template <std::size_t N>
std::vector<KnobLevel> counted_levels(const std::uint32_t (&counts)[N], const char* what) {
    std::vector<KnobLevel> levels;
    for (const std::uint32_t count : counts) levels.push_back({std::to_string(count) + what, static_cast<double>(count)});
    return levels;
}

KnobFacts sky_azimuths_facts() {
    return {"sky_azimuths",
            "Azimuths along which a post's horizon is searched",
            std::string(kSkySetting) + "sky_azimuths, 64 posts far",
            "difference of the sky view",
            "share of the sky",
            {"2048 azimuths, as far", 5e-6, "a test with 8192 azimuths finds less"},
            "closed forms of plane, wall and basin (tests/render_core/raytrace/shading)",
            kSkyNeverTrades,
            "azimuths",
            ExpectedLaw{-1.6, 0.4, "NUMERICS A28: root mean square 0.0144 at 4 to 0.0005 at 32 azimuths, about n^-1.6"},
            counted_levels(kAzimuths, " azimuths")};
}

KnobFacts sky_radius_facts() {
    return {"sky_radius",
            "How far a post's horizon is searched",
            std::string(kSkySetting) + "sky_radius, 16 azimuths",
            "difference of the sky view",
            "share of the sky",
            {"the same azimuths to the border of the measured square", 1e-12,
             "there are no posts behind it, so nothing is left out; the sum is in doubles"},
            "none: a search without an end has no other form; the search is checked by closed forms (tests/render_core/raytrace)",
            kSkyNeverTrades,
            "posts",
            ExpectedLaw{-0.85, 0.35, "NUMERICS A28: root mean square 0.035 at 4 to 0.006 at 32 of 64 posts"},
            counted_levels(kRadii, " posts")};
}

struct PostPlace {
    std::uint32_t column, row;
};

/// Sky views of single posts, in double; maps store them in 8 bits.
class SkyKnob final : public Knob {
public:
    SkyKnob(KnobFacts facts, const KnobGround& ground, std::vector<SkyMapSettings> levels, const SkyMapSettings& reference)
        : Knob(std::move(facts)), square_(ground.ground), levels_(std::move(levels)), reference_(reference) {
        for (SkyMapSettings& level : levels_) level.scale = square_.scale();
        reference_.scale = square_.scale();
        choose_posts(kPostsOfSample * (ground.is_quick ? kQuickSkySamples : kSkySamples));
        for (const PostPlace& post : posts_) exact_.push_back(sky_view(reference_, post));
    }

    [[nodiscard]] std::size_t samples() const override { return posts_.size() / kPostsOfSample; }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kPostsOfSample; ++n) seen_ += sky_view(levels_[level], posts_[sample * kPostsOfSample + n]);
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = sample * kPostsOfSample; n < (sample + 1) * kPostsOfSample; ++n)
            errors.push_back(std::abs(sky_view(levels_[level], posts_[n]) - exact_[n]));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        const PostPlace& post = posts_[sample * kPostsOfSample + error];
        return "column " + std::to_string(post.column) + ", row " + std::to_string(post.row) + " of the measured square";
    }

private:
    [[nodiscard]] double sky_view(const SkyMapSettings& settings, const PostPlace& post) const {
        return raytrace::sky_seen_at(square_.grid(), settings, post.column, post.row).view;
    }
    /// In the middle of the square, so that there is ground on every side.
    void choose_posts(std::size_t count) {
        SeededRandom numbers(12);
        const raytrace::HeightGrid<float> grid = square_.grid();
        const auto inner = [&](std::uint32_t side) {
            return static_cast<std::uint32_t>(numbers.between(side / 4.0, 3 * side / 4.0));
        };
        for (std::size_t tries = 0; posts_.size() < count && tries < count * kTriesOfPost; ++tries) {
            const PostPlace post = {inner(grid.columns), inner(grid.rows)};
            if (grid.at(post.column, post.row) != raytrace::HeightGrid<float>::kVoid) posts_.push_back(post);
        }
        if (posts_.size() < count) throw UserError("the terrain has no heights in its middle; name another --terrain");
    }

    TracedSquare square_;
    std::vector<SkyMapSettings> levels_;
    SkyMapSettings reference_;
    std::vector<PostPlace> posts_;
    std::vector<double> exact_;
    double seen_ = 0;  ///< so that no compiler leaves the search out
};

}  // namespace

std::unique_ptr<Knob> make_sky_azimuths_knob(const KnobGround& ground) {
    const std::uint32_t radius = SkyMapSettings{}.radius;
    std::vector<SkyMapSettings> levels;
    for (const std::uint32_t azimuths : kAzimuths) levels.push_back(sky_settings(azimuths, radius));
    return std::make_unique<SkyKnob>(sky_azimuths_facts(), ground, std::move(levels), sky_settings(kManyAzimuths, radius));
}

std::unique_ptr<Knob> make_sky_radius_knob(const KnobGround& ground) {
    const std::uint32_t azimuths = SkyMapSettings{}.azimuths;
    std::vector<SkyMapSettings> levels;
    for (const std::uint32_t radius : kRadii) levels.push_back(sky_settings(azimuths, radius));
    return std::make_unique<SkyKnob>(sky_radius_facts(), ground, std::move(levels),
                                     sky_settings(azimuths, TracedSquare::kMaxSide));
}

}  // namespace tedavis::host_sim
