/// A knob whose pictures of a flight are compared with those of a reference by CIEDE2000.
#pragma once

#include "host_sim/accuracy/knobs/flown_knob.hpp"

namespace tedavis::host_sim {

[[nodiscard]] inline std::string pixel_metric(const PictureSize& size) {
    return "difference of a pixel's colour, " + size_text(size) + " pixels";
}
inline constexpr const char* kTileMetric = "difference of a pixel's colour, mean over a tile of 40 x 40 of 640 x 360 pixels";
inline constexpr const char* kPictureMetric = "difference of a pixel's colour, mean over a picture of 640 x 360 pixels";
inline constexpr const char* kColorUnit = "CIEDE2000";
inline constexpr PictureSize kTile = {40, 40};

/// Which pictures are drawn, and what an error is. Pictures of another size than the reference's are scaled to it.
struct ColorPlan {
    std::vector<FlownLevel> drawn;  ///< one for each level of the facts, in their order; the reference may be a further one
    std::size_t reference = 0;      ///< its place in `drawn`
    PictureSize size = kFlownSize;  ///< of the reference's
    PictureSize tile = {1, 1};      ///< an error is the mean over one; the picture is whole tiles
};

class ColorKnob : public FlownKnob {
public:
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override;
    /// In the size of the reference's.
    [[nodiscard]] std::optional<RgbaPicture> picture(std::size_t level, std::size_t sample) override;
    [[nodiscard]] std::optional<KnobPixel> pixel_of(std::size_t sample, std::size_t error) const override;

protected:
    ColorKnob(KnobFacts facts, const ColorPlan& plan, std::vector<AircraftPose> poses);

private:
    [[nodiscard]] const RgbaPicture& exact(std::size_t sample);

    std::size_t reference_;
    PictureSize size_, tile_;
    std::vector<RgbaPicture> exact_;  ///< by pose; empty: not drawn yet
};

/// Appends the mean difference of each tile, row by row from the top. The sizes are equal, and whole tiles.
void append_color_differences(const RgbaView& picture, const RgbaView& exact, const PictureSize& tile,
                              std::vector<double>& errors);

}  // namespace tedavis::host_sim
