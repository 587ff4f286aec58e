#include "host_sim/accuracy/knobs/air_knob.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <iterator>
#include <optional>

#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/base/units.hpp"
#include "render_core/draw/drawers/air_table.hpp"
#include "render_core/draw/view_frame.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using earth::AirLight;
using Long = long double;

constexpr int kAirSteps[] = {1, 2, 4, 8, 16, 32, 64};
constexpr const char* kTableName = "the display's table";
constexpr std::size_t kTableLevel = 0;  // before those of kAirSteps
constexpr std::size_t kRaysOfAir = 32, kAirs = 32, kQuickAirs = 8;
constexpr int kReferenceSteps = 8192;
constexpr double kMinRay_m = 1000, kMaxRay_m = 400'000, kMaxEye_m = 12'000, kMaxEnd_m = 4000;

KnobFacts air_steps_facts() {
    std::vector<KnobLevel> levels;
    levels.push_back({kTableName, 0});
    for (const int steps : kAirSteps) levels.push_back({std::to_string(steps) + " steps", static_cast<double>(steps)});
    return {
        "air_steps",
        "Steps of the air along a ray",
        "steps of earth::AirPath::walk_to(); the display reads draw::AirTable, which has a step from column to column, between "
        "four places",
        "greatest difference of the light that is left and of that which molecules and aerosol add, over three colors",
        "share of light",
        {"midpoints in long double, 8192 steps that grow with the distance", 1e-7,
         "a test finds less difference to four times as many steps"},
        "columns of air in space (tests/render_core/earth)",
        "Warnings and symbols are drawn without air at every level.",
        "steps along the ray, 1 to 400 km",
        ExpectedLaw{-2, 0.4, "half of a step's own air lies before its places: an error of the second order"},
        std::move(levels)};
}

/// Nearly level rays whose ground stays below them.
bool is_over_ground(const AirRay& ray) {
    const double r = earth::kMeanRadius_m + ray.eye_height_m;
    const double lowest_at_m = std::clamp(-r * ray.sine, 0.0, ray.length_m);
    return r * r + lowest_at_m * (lowest_at_m + 2 * r * ray.sine) > earth::kMeanRadius_m * earth::kMeanRadius_m;
}

AirRay made_ray(double eye_height_m, SeededRandom& numbers) {
    AirRay ray;
    ray.eye_height_m = eye_height_m;
    do {
        ray.length_m = kMinRay_m * std::pow(kMaxRay_m / kMinRay_m, numbers.unit());
        const double from = earth::kMeanRadius_m + ray.eye_height_m, to = earth::kMeanRadius_m + numbers.between(0, kMaxEnd_m);
        ray.sine = ((to - from) * (to + from) - ray.length_m * ray.length_m) / (2 * from * ray.length_m);
    } while (std::abs(ray.sine) > 1 || !is_over_ground(ray));
    return ray;
}

/// What a half float of a texture keeps.
double of_half(double value) {
    constexpr int kMantissaBits = 10, kBias = 15;
    const unsigned bits = draw::half_of(value), exponent = bits >> kMantissaBits, mantissa = bits & ((1u << kMantissaBits) - 1);
    if (exponent == 0) return std::ldexp(mantissa, 1 - kBias - kMantissaBits);
    return std::ldexp((1u << kMantissaBits) + mantissa, static_cast<int>(exponent) - kBias - kMantissaBits);
}
glm::dvec3 of_half(const glm::dvec3& color) { return {of_half(color.x), of_half(color.y), of_half(color.z)}; }

AirLight air_between(const AirLight& a, const AirLight& b, double part) {
    return {glm::mix(a.transmittance, b.transmittance, part), glm::mix(a.by_molecules, b.by_molecules, part),
            glm::mix(a.by_aerosol, b.by_aerosol, part)};
}

/// draw::AirTable without its texture, and its reading by shaders/air.frag.
class ReadTable {
public:
    ReadTable(const earth::Air& air, const earth::SunThroughAir& sun, double eye_height_m)
        : dip_rad_(draw::horizon_dip_rad(eye_height_m)) {
        for (std::uint32_t row = 0; row < draw::AirTable::kRows; ++row) {
            earth::AirPath way(air, sun, eye_height_m, draw::AirTable::sine_of_row(row, dip_rad_));
            for (std::uint32_t column = 0; column < kColumns; ++column) {
                way.walk_to(draw::AirTable::distance_of_column_m(column), 1);
                const AirLight light = way.light();
                places_.push_back({of_half(light.transmittance), of_half(light.by_molecules), of_half(light.by_aerosol)});
            }
        }
    }
    [[nodiscard]] AirLight light(double sine, double length_m) const {
        constexpr double kColumnsOfOctave = 62.0 / 9.6456, kFirst_m = 1000, kMiddle = 0.5 * (draw::AirTable::kRows - 1);
        const double column = std::min(std::log2(1 + length_m / kFirst_m) * kColumnsOfOctave, kColumns - 1.0);
        const double above = std::clamp(sine + std::sin(dip_rad_), -1.0, 1.0);
        const double row = kMiddle + kMiddle * std::copysign(std::sqrt(std::abs(above)), above);
        const auto upper = std::min(static_cast<std::size_t>(row), std::size_t{draw::AirTable::kRows - 2});
        const double part = row - static_cast<double>(upper);
        return air_between(in_row(upper, column), in_row(upper + 1, column), part);
    }

private:
    static constexpr std::uint32_t kColumns = draw::AirTable::kColumns - 1;  // without that of rays that leave the air

    [[nodiscard]] AirLight in_row(std::size_t row, double column) const {
        const auto before = std::min(static_cast<std::size_t>(column), std::size_t{kColumns - 2});
        const std::size_t at = row * kColumns + before;
        return air_between(places_[at], places_[at + 1], column - static_cast<double>(before));
    }

    double dip_rad_;
    std::vector<AirLight> places_;  ///< row by row
};

/// Air, sun and an eye point, with rays from there and what the air does to them.
class SampledAir {
public:
    explicit SampledAir(SeededRandom& numbers)
        : air_(earth::air_of_visibility(numbers.between(20'000, 120'000))),
          sun_(air_, base::radians(numbers.between(5, 80))),
          eye_height_m_(numbers.between(50, kMaxEye_m)) {
        const auto begin = std::chrono::steady_clock::now();
        table_.emplace(air_, sun_, eye_height_m_);
        table_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
        for (std::size_t n = 0; n < kRaysOfAir; ++n) {
            rays_.push_back(made_ray(eye_height_m_, numbers));
            exact_.push_back(air_by_midpoints(air_, sun_, rays_.back(), kReferenceSteps));
        }
    }

    [[nodiscard]] const AirRay& ray(std::size_t number) const { return rays_[number]; }
    [[nodiscard]] double table_ms() const { return table_ms_; }
    [[nodiscard]] AirLight light(std::size_t level, std::size_t number) const {
        const AirRay& ray = rays_[number];
        if (level == kTableLevel) return table_->light(ray.sine, ray.length_m);
        earth::AirPath way(air_, sun_, ray.eye_height_m, ray.sine);
        way.walk_to(ray.length_m, kAirSteps[level - 1]);
        return way.light();
    }
    [[nodiscard]] double difference(std::size_t level, std::size_t number) const {
        const AirLight found = light(level, number), &exact = exact_[number];
        double most = 0;
        for (int band = 0; band < 3; ++band)
            most = std::max({most, std::abs(found.transmittance[band] - exact.transmittance[band]),
                             std::abs(found.by_molecules[band] - exact.by_molecules[band]),
                             std::abs(found.by_aerosol[band] - exact.by_aerosol[band])});
        return most;
    }

private:
    earth::Air air_;
    earth::SunThroughAir sun_;
    double eye_height_m_, table_ms_ = 0;
    std::optional<ReadTable> table_;
    std::vector<AirRay> rays_;
    std::vector<AirLight> exact_;
};

class AirStepsKnob final : public Knob {
public:
    explicit AirStepsKnob(const KnobGround& ground) : Knob(air_steps_facts()) {
        SeededRandom numbers(12);
        for (std::size_t n = 0; n < (ground.is_quick ? kQuickAirs : kAirs); ++n)
            airs_.push_back(std::make_unique<SampledAir>(numbers));
    }

    [[nodiscard]] std::size_t samples() const override { return airs_.size(); }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kRaysOfAir; ++n) {
            const AirLight light = airs_[sample]->light(level, n);
            seen_ += light.transmittance + light.by_molecules + light.by_aerosol;
        }
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = 0; n < kRaysOfAir; ++n) errors.push_back(airs_[sample]->difference(level, n));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        const AirRay& ray = airs_[sample]->ray(error);
        char text[120];
        std::snprintf(text, sizeof text, "air %zu, a ray of %.1f km from %.0f m, %.2f degrees up", sample, ray.length_m / 1000,
                      ray.eye_height_m, base::degrees(std::asin(ray.sine)));
        return text;
    }
    [[nodiscard]] std::uint64_t bytes(std::size_t level) const override {
        constexpr std::uint64_t kTexelBytes = 8;
        using draw::AirTable;
        return level == kTableLevel ? kTexelBytes * AirTable::kRows * AirTable::kColumns * AirTable::kBlocks : 0;
    }
    [[nodiscard]] double build_ms(std::size_t level) const override {
        return level == kTableLevel ? airs_.front()->table_ms() : 0;
    }

private:
    std::vector<std::unique_ptr<SampledAir>> airs_;
    glm::dvec3 seen_{0};  ///< so that no compiler leaves the air out
};

/// Air along a ray, summed up in long double.
class LongAir {
public:
    LongAir(const earth::Air& air, const earth::SunThroughAir& sun) : air_(air), sun_(sun) {}

    void add(Long height_m, Long length_m) {
        const Long molecules_m = std::exp(-height_m / static_cast<Long>(air_.molecules_height_m)) * length_m;
        const Long aerosol_m = std::exp(-height_m / static_cast<Long>(air_.aerosol_height_m)) * length_m;
        const glm::dvec3 lit = sun_.at(static_cast<double>(height_m));
        for (int band = 0; band < 3; ++band) {
            const Long of_molecules = air_.molecules_per_m[band], of_aerosol = air_.aerosol_per_m;
            const Long left = std::exp(-depth(band, molecules_m_ + molecules_m / 2, aerosol_m_ + aerosol_m / 2));
            by_molecules_[band] += left * static_cast<Long>(lit[band]) * molecules_m * of_molecules;
            by_aerosol_[band] += left * static_cast<Long>(lit[band]) * aerosol_m * of_aerosol;
        }
        molecules_m_ += molecules_m;
        aerosol_m_ += aerosol_m;
    }
    [[nodiscard]] AirLight light() const {
        AirLight light;
        for (int band = 0; band < 3; ++band) {
            light.transmittance[band] = static_cast<double>(std::exp(-depth(band, molecules_m_, aerosol_m_)));
            light.by_molecules[band] = static_cast<double>(by_molecules_[band]);
            light.by_aerosol[band] = static_cast<double>(by_aerosol_[band]);
        }
        return light;
    }

private:
    [[nodiscard]] Long depth(int band, Long molecules_m, Long aerosol_m) const {
        return static_cast<Long>(air_.molecules_per_m[band]) * molecules_m +
               static_cast<Long>(air_.aerosol_per_m) / static_cast<Long>(earth::kAerosolAlbedo) * aerosol_m;
    }

    const earth::Air& air_;
    const earth::SunThroughAir& sun_;
    Long molecules_m_ = 0, aerosol_m_ = 0, by_molecules_[3] = {}, by_aerosol_[3] = {};
};

}  // namespace

AirLight air_by_midpoints(const earth::Air& air, const earth::SunThroughAir& sun, const AirRay& ray, int steps) {
    const Long radius = earth::kMeanRadius_m, up = ray.sine, level = std::sqrt(1 - up * up), length = ray.length_m;
    LongAir sum(air, sun);
    const auto distance_at = [&](int step) {
        const Long part = static_cast<Long>(step) / steps;
        return length * part * (part + 1) / 2;
    };
    for (int step = 0; step < steps; ++step) {
        const Long from = distance_at(step), to = distance_at(step + 1), at = (from + to) / 2;
        const Long height_m = std::hypot(at * level, radius + static_cast<Long>(ray.eye_height_m) + at * up) - radius;
        sum.add(height_m, to - from);
    }
    return sum.light();
}

std::unique_ptr<Knob> make_air_steps_knob(const KnobGround& ground) { return std::make_unique<AirStepsKnob>(ground); }

}  // namespace tedavis::host_sim
