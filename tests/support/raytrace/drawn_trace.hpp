/// Traced pictures over generated hills, with the memory that they take.
#pragma once

#include <cmath>
#include <cstring>
#include <vector>

#include "render_core/base/check.hpp"
#include "render_core/raytrace/picture/trace_picture.hpp"
#include "tests/support/raytrace/trace_cameras.hpp"
#include "tests/support/terrain/fractal_heights.hpp"

namespace tedavis::test_support {

inline const glm::vec3 kGroundPalette[] = {{0.05f, 0.2f, 0.3f}, {0.12f, 0.3f, 0.08f}, {0.35f, 0.3f, 0.15f}, {0.8f, 0.8f, 0.82f}};

/// Posts 30 m apart; the highest hills are 0.15 side of them high.
inline raytrace::GridScale hills_scale(std::uint32_t side) { return {30, 30, 30 / steps_a_cell(side)}; }

inline raytrace::TraceLook hills_look(std::uint32_t side) {
    raytrace::TraceLook look;
    look.sun = {glm::normalize(glm::dvec3(0.5, -0.6, 0.55)), glm::vec3(0.9f, 0.85f, 0.75f)};
    look.sky = {0.2f, 0.25f, 0.35f};
    look.background = {0.45f, 0.6f, 0.8f};
    look.material.gloss = 0.2f;
    look.material.sharpness = 20;
    look.ground = {kGroundPalette, 0, static_cast<float>(0.15 * side * steps_a_cell(side))};
    return look;
}

/// Everything that draws a picture of hills by any of some settings.
class DrawnTrace {
public:
    using Height = std::int16_t;

    DrawnTrace(const HeightField<Height>& posts, const std::vector<raytrace::TraceSettings>& all, std::uint32_t width,
               std::uint32_t height, const raytrace::StreamSettings& stream = {})
        : settings(all), rgb(std::size_t{3} * width * height), posts_(posts) {
        raytrace::SceneSize size;
        size.width = width;
        size.height = height;
        size.sky_azimuths = 8;
        size.sky_radius = 24;
        const raytrace::HeightGrid<Height> grid = posts_.grid();
        const std::uint64_t bytes = raytrace::TracedScene<Height>::bytes_needed(grid, settings) +
                                    raytrace::TracePicture<Height>::bytes_needed(width, height, stream);
        memory_.resize(bytes / 8 + 64);
        base::Arena arena(memory_.data(), memory_.size() * 8);
        look = hills_look(posts_.columns);
        TEDAVIS_CHECK(scene.start(grid, hills_scale(posts_.columns), settings, size, arena).ok());
        TEDAVIS_CHECK(picture.start(width, height, stream, arena).ok());
        base::SerialWorkers alone;
        scene.build(alone);
        set_camera(trace_cameras(posts_.columns, width, height)[3].in_steps(steps_a_cell(posts_.columns)).view());
    }
    DrawnTrace(const DrawnTrace&) = delete;

    void set_camera(const raytrace::GridCamera& camera) {
        scene.set_view(raytrace::PictureSight::of_grid(camera), raytrace::view_kernels<Height>()[0],
                       raytrace::view_kernels<float>()[0]);
    }
    [[nodiscard]] bool begin(std::uint32_t of_settings = 0) {
        return picture.begin(scene, look, {base::Span<const raytrace::TraceSettings>(settings).subspan(of_settings, 1), {}}, rgb);
    }
    [[nodiscard]] bool draw(base::Workers& workers, std::uint32_t of_settings = 0) {
        if (!begin(of_settings)) return false;
        const raytrace::StreamRewriter::Answer answer = picture.rewrite(workers);
        if (!answer.ok()) std::fprintf(stderr, "%s\n", answer.error().c_str());
        if (answer.ok()) report = answer.value();
        return answer.ok() && report.is_finished;
    }
    void draw_directly(base::Workers& workers, std::uint32_t of_settings = 0) {
        TEDAVIS_CHECK(begin(of_settings));
        picture.draw_directly(workers);
    }
    [[nodiscard]] std::vector<glm::vec3> light() const {
        return {picture.stages().light().begin(), picture.stages().light().end()};
    }
    [[nodiscard]] static bool is_same(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
    }

    std::vector<raytrace::TraceSettings> settings;
    raytrace::TraceLook look;
    raytrace::TracedScene<Height> scene;
    raytrace::TracePicture<Height> picture;
    std::vector<std::uint8_t> rgb;
    raytrace::RewriteReport report;  ///< of the last draw()

private:
    HeightField<Height> posts_;
    std::vector<std::uint64_t> memory_;
};

}  // namespace tedavis::test_support
