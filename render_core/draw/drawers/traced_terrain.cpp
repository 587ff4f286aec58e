#include "render_core/draw/drawers/traced_terrain.hpp"

#include "render_core/base/check.hpp"
#include "render_core/draw/shader_texts.hpp"

namespace tedavis::draw {
namespace {

enum TracedUniform : std::size_t { kDepths, kDepthRange, kTracedUniforms };
constexpr const char* kTracedUniformNames[kTracedUniforms] = {"depths", "depth_range"};
constexpr gl::AttributeBinding kTracedCorners[] = {{"position", 0}};

bool is_same_picture(const terrain::View& a, const terrain::View& b) {
    return a.eye == b.eye && a.forward == b.forward && a.right == b.right && a.down == b.down && a.focal_px == b.focal_px &&
           a.width == b.width && a.height == b.height && a.far_m == b.far_m;
}

TraceState traced_state_of(TracedGroundFault fault) {
    constexpr TraceState kStates[] = {TraceState::traced, TraceState::database_too_large, TraceState::database_round,
                                      TraceState::database_damaged};
    return kStates[static_cast<std::size_t>(fault)];
}

}  // namespace

base::Error TracedTerrain::start(gl::Gl& gl, const terrain::TerrainDatabase& database, terrain::HeightQuery& heights,
                                 effects::DeviceSettings& device, const TracePlace& place) {
    database_ = &database;
    place_ = place;
    state_ = start_memory(heights, device, place);
    return state_ == TraceState::traced ? start_pictures(gl, device.budget) : base::Error{};
}

TraceState TracedTerrain::start_memory(terrain::HeightQuery& heights, const effects::DeviceSettings& device,
                                       const TracePlace& place) {
    if (device.capability.lane != effects::Lane::es3) return TraceState::not_on_lane;
    const std::uint64_t pixels = std::uint64_t{place.width_px} * place.height_px;
    const base::BudgetLine* pictures = device.budget.find(effects::kTracedPictures);
    const std::uint64_t texel_bytes = place.writes_words ? kShadedTexelBytes : sizeof(float);
    if (place.memory == nullptr || pictures == nullptr || pictures->bytes < texel_bytes * pixels)
        return TraceState::not_on_device;
    codes_ = place.memory->allocate_array<std::uint8_t>(4 * pixels);
    if (codes_.empty() || !view_.start(place.width_px, place.height_px, *place.memory)) return TraceState::not_on_device;
    if (place.writes_words && !words_.start(database_->lattice(), place.width_px, place.height_px, *place.memory))
        return TraceState::not_on_device;
    return traced_state_of(ground_.start(heights, workers(), *place.memory));
}

base::Error TracedTerrain::start_pictures(gl::Gl& gl, base::BudgetTable& budget) {
    const gl::TextureSettings texels{gl::TextureFormat::rgba8, gl::TextureFilter::nearest, place_.width_px, place_.height_px};
    auto depths = gl::make_texture(gl, *budget.find(effects::kTracedPictures), texels);
    if (!depths.ok()) return depths.error();
    depths_ = static_cast<gl::Texture&&>(depths.value());
    if (place_.writes_words)
        if (base::Error error = geometry_.start(gl, budget, place_.width_px, place_.height_px)) return error;
    if (base::Error error = screen_.start(gl, budget)) return error;
    auto program = gl::build_program(
        gl, {"traced depths", shader_text(k_saliency_vert), shader_text(k_traced_depth_frag),
             base::Span<const gl::AttributeBinding>(kTracedCorners), base::Span<const char* const>(kTracedUniformNames), true});
    if (!program.ok()) return program.error();
    program_ = program.value();
    return {};
}

void TracedTerrain::see(const terrain::View& view) {
    if (has_seen_ && is_same_picture(view, seen_)) return;
    if (can_trace(*database_, view))
        view_.trace(ground_, space(), view, workers());
    else
        view_.clear();
    seen_ = view;
    has_seen_ = true;
    has_depths_ = false;
}

void TracedTerrain::draw(gl::Gl& gl, const design::DesignSettings& design, const TerrainDrawInput& input,
                         const gl::Texture& picture) {
    see(input.view);
    has_words_ = false;
    write_codes({ground_, view_.hits(), input.view, input.heights, coded_light(design.terrain.style.shade, input.light_direction),
                 &input.alert},
                workers(), codes_);
    TEDAVIS_CHECK(picture.upload(gl, {0, 0, place_.width_px, place_.height_px}, codes_.data()));
}

const gl::Texture& TracedTerrain::draw_words(gl::Gl& gl, base::Span<const terrain::SelectedChunk> chunks,
                                             const TerrainDrawInput& input) {
    see(input.view);
    has_words_ = true;
    words_.write({ground_, view_.hits(), input.view, chunks}, workers());
    geometry_.upload(gl, words_.words());
    geometry_.leave_numbers(gl);
    return geometry_.words();
}

/// The shader puts the bytes of floats together as they lie here: least significant first.
void TracedTerrain::draw_depths(gl::Gl& gl, const TerrainDrawInput& input, const DepthRange& range) {
    see(input.view);
    if (has_words_) return geometry_.leave_depths(gl, range);
    if (!has_depths_) TEDAVIS_CHECK(depths_.upload(gl, {0, 0, place_.width_px, place_.height_px}, view_.hits().t.data()));
    has_depths_ = true;
    depths_.bind(gl, 0);
    program_.use(gl);
    gl->Uniform1i(program_.uniform(kDepths), 0);
    gl->Uniform2f(program_.uniform(kDepthRange), static_cast<float>(range.near_m), static_cast<float>(range.far_m));
    screen_.draw(gl);
}

void TracedTerrain::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    screen_.destroy(gl);
    depths_.destroy(gl);
    geometry_.destroy(gl);
}

}  // namespace tedavis::draw
