/// Draws pictures of the ground with the ray tracer, and owns the memory that this needs.
#pragma once

#include <algorithm>

#include "host_sim/tracing/traced_shot.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/raytrace/picture/trace_picture.hpp"

namespace tedavis::host_sim {

/// Returns the lengths of the units of grid space at the row below the eye, or at the nearest row of the ground.
inline raytrace::GridScale scale_at(const TracedGround& ground, const terrain::View& view) {
    const raytrace::GroundSpace& space = ground.space();
    const double row = std::clamp(space.place(view.eye).y, 0.0, ground.rows() - 1.0);
    return {space.column_m(row), space.row_m(row), space.step_m()};
}

template <class Height>
class ShotDrawer {
public:
    ShotDrawer(const TracedGround& ground, const std::vector<raytrace::TraceSettings>& settings, const TracedShotPlan& plan)
        : ShotDrawer(ground, plan, settings) {
        const raytrace::HeightGrid<Height> grid = ground.grid<Height>();
        base::Arena arena = reserve(raytrace::TracedScene<Height>::bytes_needed(grid, settings_));
        require(scene_.start(grid, scale_at(ground, view_), settings_, size_, arena));
        require(picture_.start(size_.width, size_.height, stream_, arena));
    }
    /// Draws over `terrain`, which finds the hits of the rays and must outlive the drawer.
    ShotDrawer(const TracedGround& ground, const raytrace::TracedTerrain& terrain, const raytrace::TraceSettings& settings,
               const TracedShotPlan& plan)
        : ShotDrawer(ground, plan, {settings}) {
        base::Arena arena = reserve(0);
        require(scene_.start(terrain, scale_at(ground, view_), settings_.front(), size_));
        require(picture_.start(size_.width, size_.height, stream_, arena));
    }

    void build(const TracedGround& ground, base::Workers& workers) {
        scene_.build(workers);
        scene_.set_view(raytrace::PictureSight::of_world(ground.space(), view_), raytrace::view_kernels<Height>()[0],
                        raytrace::view_kernels<float>()[0]);
    }
    /// `regions` states, row by row, the number of the settings for each region of the picture; empty: the first settings are
    /// used everywhere. Returns the number of rounds of the token stream; 0 if `is_direct`, which calls the stages without the
    /// stream.
    std::uint32_t draw(const raytrace::TraceLook& look, base::Span<const std::uint8_t> regions, bool is_direct,
                       base::Workers& workers) {
        if (!picture_.begin(scene_, look, {settings_, regions}, rgb_))
            throw UserError("the token stream has no room; give it less");
        if (is_direct) {
            picture_.draw_directly(workers);
            return 0;
        }
        const raytrace::StreamRewriter::Answer answer = picture_.rewrite(workers);
        if (!answer.ok()) throw UserError(std::string(answer.error().view()));
        return answer.value().rounds;
    }
    [[nodiscard]] const raytrace::TraceStages<Height>& stages() const { return picture_.stages(); }
    void tell(TracedShot& shot) const {
        for (const raytrace::PreparedItem& item : scene_.items())
            shot.items.push_back({std::string(item.name.view()), item.bytes});
        shot.kernel = raytrace::view_kernels<Height>()[0].name;
        shot.pieces = static_cast<std::uint32_t>(raytrace::cut_view(view_).count);
        std::size_t hit_count = 0;
        for (const std::int32_t cell : picture_.stages().hits().cell) hit_count += cell >= 0 ? 1 : 0;
        shot.ground_share = static_cast<double>(hit_count) / (static_cast<double>(view_.width) * view_.height);
        shot.pixels.width = view_.width;
        shot.pixels.height = view_.height;
        shot.pixels.pixels.resize(rgb_.size() / 3 * 4, 255);
        for (std::size_t n = 0; n < rgb_.size() / 3; ++n) std::copy_n(&rgb_[3 * n], 3, &shot.pixels.pixels[4 * n]);
    }

    [[nodiscard]] const raytrace::PictureSight& sight() const { return scene_.sight(); }

private:
    ShotDrawer(const TracedGround& ground, const TracedShotPlan& plan, const std::vector<raytrace::TraceSettings>& settings)
        : settings_(settings), view_(view_of(ground, plan)) {
        for (raytrace::TraceSettings& each : settings_) each.has_data = plan.data != nullptr;
        if (!raytrace::can_trace(ground.space(), view_))
            throw UserError("the pose is too close to a pole, or too far from the terrain, for the tracer; name another one");
        stream_.block_words = plan.block_words;
        size_.width = plan.width;
        size_.height = plan.height;
        rgb_.resize(std::size_t{3} * plan.width * plan.height);
    }
    /// Allocates memory for a picture and for `scene_bytes` bytes of the scene.
    base::Arena reserve(std::uint64_t scene_bytes) {
        memory_.resize((scene_bytes + raytrace::TracePicture<Height>::bytes_needed(size_.width, size_.height, stream_)) / 8 + 64);
        return {memory_.data(), memory_.size() * 8};
    }
    template <class Answer>
    static void require(const Answer& answer) {
        if (!answer.ok()) throw UserError(std::string(answer.error().view()));
    }

    std::vector<raytrace::TraceSettings> settings_;
    terrain::View view_;
    raytrace::StreamSettings stream_;
    raytrace::SceneSize size_;
    std::vector<std::uint64_t> memory_;
    raytrace::TracedScene<Height> scene_;
    raytrace::TracePicture<Height> picture_;
    std::vector<std::uint8_t> rgb_;
};

}  // namespace tedavis::host_sim
