#include "host_sim/accuracy/knobs/color_classes_knob.hpp"

#include <cmath>
#include <cstdio>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/design/data_scale.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kClassCounts[] = {2, 4, 8, design::kMaxClasses};
constexpr std::size_t kColoredValues = 8192, kColoredSamples = 32, kQuickColoredSamples = 8;

KnobFacts color_classes_facts() {
    std::vector<KnobLevel> levels;
    for (const std::size_t count : kClassCounts)
        levels.push_back({std::to_string(count) + " classes", static_cast<double>(count)});
    return {"color_classes",
            "Classes of a colour scale",
            "`classes` of a data element's scale, 2 to 16; here of the palette alpine",
            "difference of the middle of the class that a colour stands for from the value",
            "m of height",
            {"the value itself", 1e-9, "values and limits of classes are doubles below 10 km"},
            "none: a value needs none; a test reads values back from their colours",
            "Colours of warnings have no classes.",
            "classes",
            ExpectedLaw{-1, 0.02, "NUMERICS K18: at most span / (2 classes)"},
            std::move(levels)};
}

/// The value that a reader of the legend takes for a class.
double value_of_class(const design::DataScale& scale, std::size_t number) {
    const double from = number == 0 ? scale.palette.stops[0].value : scale.breaks[number - 1];
    const double to = number == scale.breaks.size() ? scale.palette.stops.back().value : scale.breaks[number];
    return 0.5 * (from + to);
}

class ColorClassesKnob final : public Knob {
public:
    explicit ColorClassesKnob(const KnobGround& ground) : Knob(color_classes_facts()) {
        for (const std::size_t count : kClassCounts) {
            design::DataScale& scale = scales_.emplace_back();
            scale.palette = design::alpine_palette();
            design::reduce_classes(scale, count);
        }
        SeededRandom numbers(16);
        const auto& stops = scales_.front().palette.stops;
        const std::size_t count = kColoredValues * (ground.is_quick ? kQuickColoredSamples : kColoredSamples);
        for (std::size_t n = 0; n < count; ++n) values_.push_back(numbers.between(stops[0].value, stops.back().value));
    }

    [[nodiscard]] std::size_t samples() const override { return values_.size() / kColoredValues; }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kColoredValues; ++n)
            colored_ += static_cast<double>(design::scale_color(scales_[level], values_[sample * kColoredValues + n]).red);
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        const design::DataScale& scale = scales_[level];
        for (std::size_t n = sample * kColoredValues; n < (sample + 1) * kColoredValues; ++n)
            errors.push_back(std::abs(value_of_class(scale, design::class_of(scale, values_[n])) - values_[n]));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        char text[40];
        std::snprintf(text, sizeof text, "a height of %.1f m", values_[sample * kColoredValues + error]);
        return text;
    }

private:
    std::vector<design::DataScale> scales_;  ///< by level
    std::vector<double> values_;
    double colored_ = 0;  ///< so that no compiler leaves the colours out
};

}  // namespace

std::unique_ptr<Knob> make_color_classes_knob(const KnobGround& ground) { return std::make_unique<ColorClassesKnob>(ground); }

}  // namespace tedavis::host_sim
