#include "host_sim/accuracy/knobs/color_knob.hpp"

#include <algorithm>

#include "host_sim/accuracy/knobs/scaled_picture.hpp"
#include "host_sim/measure/lab_picture.hpp"

namespace tedavis::host_sim {

ColorKnob::ColorKnob(KnobFacts facts, const ColorPlan& plan, std::vector<AircraftPose> poses)
    : FlownKnob(std::move(facts), plan.drawn, std::move(poses)),
      reference_(plan.reference),
      size_(plan.size),
      tile_(plan.tile),
      exact_(pictures().poses().size()) {}

const RgbaPicture& ColorKnob::exact(std::size_t sample) {
    RgbaPicture& picture = exact_[sample];
    if (picture.pixels.empty()) picture = upright(pictures().picture(reference_, sample));
    return picture;
}

void ColorKnob::find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) {
    const RgbaPicture& reference = exact(sample);
    const RgbaView drawn = pictures().picture(level, sample);
    if (drawn.width == reference.width && drawn.height == reference.height)
        return append_color_differences(drawn, view_of(reference), tile_, errors);
    const RgbaPicture scaled = scaled_picture(drawn, {reference.width, reference.height});
    append_color_differences(view_of(scaled), view_of(reference), tile_, errors);
}

std::string ColorKnob::place_of(std::size_t sample, std::size_t error) const {
    const std::uint32_t tiles_across = size_.width / tile_.width;
    const auto number = static_cast<std::uint32_t>(error);
    return pixel_text(sample, number % tiles_across * tile_.width + tile_.width / 2,
                      number / tiles_across * tile_.height + tile_.height / 2);
}

void append_color_differences(const RgbaView& picture, const RgbaView& exact, const PictureSize& tile,
                              std::vector<double>& errors) {
    const LabPicture found(picture), truth(exact);
    const std::uint32_t tiles_across = picture.width / tile.width;
    const std::size_t begin = errors.size();
    errors.resize(begin + std::size_t{tiles_across} * (picture.height / tile.height), 0);
    const double share = 1.0 / (static_cast<double>(tile.width) * tile.height);
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const std::uint8_t *const a = picture.row(y) + std::size_t{4} * x, *const b = exact.row(y) + std::size_t{4} * x;
            if (std::equal(a, a + 3, b)) continue;
            errors[begin + std::size_t{y / tile.height} * tiles_across + x / tile.width] +=
                share * design::color_difference(found.at(x, y), truth.at(x, y));
        }
}

}  // namespace tedavis::host_sim
