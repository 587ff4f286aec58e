#include "render_core/draw/drawers/traced_codes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render_core/draw/drawers/terrain_program.hpp"
#include "render_core/draw/drawers/traced_surface.hpp"

namespace tedavis::draw {
namespace {

using raytrace::HitSide;

constexpr std::uint32_t kRowsOfTask = 8;
constexpr float kHeightSteps = 254.0f, kHighestShare = 1.0f - 1.0f / 65536.0f;  // step 254 is the sea
constexpr std::uint8_t kSeaStep = 254;
constexpr std::uint32_t kAlertSteps = 85;
constexpr double kFarthestCode = 254;  // 255 is the sky

/// Rounded; a call of lround() for each pixel would cost more than all of its code.
std::uint8_t byte_of(float share) {
    const float above = share * 255.0f + 0.5f;
    return static_cast<std::uint8_t>(above);
}

/// The codes of distances by their floats' uppermost bits: steps are told apart to a 26th of one.
class DistanceCodes {
public:
    DistanceCodes() {
        for (std::uint32_t n = 0; n < kEntries; ++n) {
            const std::uint32_t octave = n / kPerOctave;
            const double within = (n % kPerOctave + 0.5) / kPerOctave;
            const double code = 255 * (octave + std::log2(1 + within)) / kDistanceCodeOctaves;
            codes_[n] = static_cast<std::uint8_t>(std::lround(std::fmin(code, kFarthestCode)));
        }
    }
    [[nodiscard]] std::uint8_t of(float distance_m) const {
        const float value = 1 + distance_m / static_cast<float>(kDistanceCodeStart_m);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        return codes_[std::min((bits - kBitsOfOne) >> kBitsLeft, kEntries - 1)];
    }

private:
    static constexpr std::uint32_t kBitsOfOne = 0x3F800000, kBitsLeft = 14, kPerOctave = 1u << (23 - kBitsLeft);
    static constexpr std::uint32_t kEntries = kPerOctave * static_cast<std::uint32_t>(kDistanceCodeOctaves);
    std::uint8_t codes_[kEntries];
};

/// What does not change over a picture, in floats; a triangle's three corners side by side.
struct Coder {
    explicit Coder(const CodeInput& given) : input(given), surface(given.ground, given.hits) {
        lowest_m = static_cast<float>(given.heights.lowest_m);
        const double reach_m = given.heights.highest_m - given.heights.lowest_m;
        per_m = reach_m > 0 ? static_cast<float>(1 / reach_m) : 1.0f;
        for (std::size_t n = 0; n < given.light.count; ++n)
            for (int axis = 0; axis < 3; ++axis)  // normals have steps of 1/127
                lights[n][axis] = static_cast<float>(given.light.towards[n][axis] * given.light.weights[n] / 127);
        ambient = static_cast<float>(given.light.ambient);
    }

    /// Light at the corners.
    [[nodiscard]] CornerFloats light_of(const TracedPoint& point) const {
        const CornerFloats x = point.normals_x(), y = point.normals_y(), z = point.normals_z();
        CornerFloats direct{};
        for (std::size_t n = 0; n < input.light.count; ++n) {
            const CornerFloats facing = x * lights[n][0] + y * lights[n][1] + z * lights[n][2];
            direct += facing > 0 ? facing : CornerFloats{};
        }
        return ambient + (1 - ambient) * direct;
    }

    /// Returns the height above MSL, m.
    float code(std::size_t pixel, float distance_m, std::uint8_t* to) const;
    /// Codes what an alert says of the ground that was met there.
    void code_alert(const glm::dvec3& place, float height_m, std::uint8_t* to) const;

    const CodeInput& input;
    const TracedSurface surface;
    float lowest_m, per_m, ambient;
    float lights[design::kMaxLights][3]{};
    DistanceCodes distances;
};

float Coder::code(std::size_t pixel, float distance_m, std::uint8_t* to) const {
    const TracedPoint point = surface.at(pixel);
    const float lit = input.light.count > 0 ? sum_of(point.shares * light_of(point)) : 1.0f;
    const float steps = std::clamp((point.height_m - lowest_m) * per_m, 0.0f, kHighestShare) * kHeightSteps;
    const auto whole = static_cast<std::uint8_t>(steps);
    to[0] = point.is_sea ? kSeaStep : whole;
    to[1] = point.is_sea ? std::uint8_t{0} : byte_of(steps - static_cast<float>(whole));
    to[2] = point.is_unknown ? std::uint8_t{0} : byte_of(std::clamp(lit, 1.0f / 255.0f, 1.0f));
    to[3] = distances.of(distance_m);
    return point.height_m;
}

/// As shaders/terrain_code.frag.
void Coder::code_alert(const glm::dvec3& place, float height_m, std::uint8_t* to) const {
    const std::uint32_t alert = static_cast<std::uint32_t>(input.alert->at(place, double{height_m}));
    to[1] = static_cast<std::uint8_t>(std::min(to[1] / 3u, kAlertSteps - 1) * 3 + alert);
}

struct CodeJob {
    const Coder& coder;
    std::uint8_t* codes;
};

void write_rows(const CodeJob& job, std::uint32_t task) {
    const terrain::View& view = job.coder.input.view;
    const raytrace::HitPicture& hits = job.coder.input.hits;
    const bool is_alert = job.coder.input.alert != nullptr && job.coder.input.alert->is_shown();
    const double pixel = 1 / view.focal_px;
    for (std::uint32_t y = task * kRowsOfTask; y < std::min(view.height, (task + 1) * kRowsOfTask); ++y) {
        const double down = (y + 0.5) * pixel - view.half_height_tangent();
        const auto level = static_cast<float>(1 + down * down);
        std::uint8_t* to = job.codes + std::size_t{view.height - 1 - y} * view.width * 4;
        for (std::uint32_t x = 0; x < view.width; ++x, to += 4) {
            const std::size_t at = std::size_t{y} * view.width + x;
            if (hits.side[at] == HitSide::none) {
                std::memset(to, kNothingCode, 4);
                continue;
            }
            const auto right = static_cast<float>((x + 0.5) * pixel - view.half_width_tangent());
            const float height_m = job.coder.code(at, hits.t[at] * std::sqrt(level + right * right), to);
            if (!is_alert) continue;
            const glm::dvec3 way = view.forward + view.right * double{right} + view.down * down;
            job.coder.code_alert(view.eye + double{hits.t[at]} * way, height_m, to);
        }
    }
}

}  // namespace

CodedLight coded_light(const design::ShadeSettings& shade, const glm::dvec3* towards) {
    CodedLight light;
    if (shade.technique == design::TerrainShade::none) return light;
    light.count = shade.technique == design::TerrainShade::lights ? shade.light_count : 1;
    light.ambient = shade.ambient;
    double sum = 0;
    for (std::size_t n = 0; n < light.count; ++n) sum += shade.lights[n].weight;
    for (std::size_t n = 0; n < light.count; ++n) {
        light.towards[n] = towards[n];
        light.weights[n] = light.count > 1 && sum > 0 ? shade.lights[n].weight / sum : 1;
    }
    return light;
}

void write_codes(const CodeInput& input, base::Workers& workers, base::Span<std::uint8_t> codes) {
    const Coder coder(input);
    CodeJob job{coder, codes.data()};
    const auto task = [](void* context, std::uint32_t n) { write_rows(*static_cast<CodeJob*>(context), n); };
    workers.parallel_for((input.view.height + kRowsOfTask - 1) / kRowsOfTask, task, &job);
}

}  // namespace tedavis::draw
