#include "host_sim/measure/sign_contrast.hpp"

#include <algorithm>
#include <array>

#include "render_core/design/color.hpp"
#include "render_core/perception/contrast_ratio.hpp"

namespace tedavis::host_sim {
namespace {

using perception::contrast_ratio;

constexpr std::size_t kOwnParts = 20, kAroundParts = 10;
constexpr std::size_t kMaxOfPart = 48;  // pixels: a stroke on a large panel is less than a twentieth of it

/// The values that the lowest and the highest of so many equal parts reach, and the middle one. Puts them in another order.
struct Quantiles {
    double low, middle, high;
};
Quantiles quantiles(std::vector<double>& values, std::size_t parts) {
    const std::size_t last = values.size() - 1, part = std::min(last / parts, kMaxOfPart);
    const auto ranked = [&values](std::size_t rank) {
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
        std::nth_element(values.begin(), at, values.end());
        return *at;
    };
    return {ranked(part), ranked(last / 2), ranked(last - part)};
}

class PatchReader {
public:
    PatchReader(const RgbaPicture& picture, const LayerMask& mask, std::uint8_t layer)
        : picture_(picture),
          mask_(mask),
          layer_(layer),
          width_(static_cast<int>(mask.width)),
          height_(static_cast<int>(mask.height)),
          taken_(mask.layers.size(), 0),
          seen_(mask.layers.size(), 0) {
        for (std::size_t level = 0; level < red_.size(); ++level) {
            const auto channel = static_cast<std::uint8_t>(level);
            red_[level] = design::relative_luminance({channel, 0, 0});
            green_[level] = design::relative_luminance({0, channel, 0});
            blue_[level] = design::relative_luminance({0, 0, channel});
        }
    }

    [[nodiscard]] std::vector<SignContrast> read(std::uint32_t least_px) {
        std::vector<SignContrast> signs;
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                if (taken_[index(x, y)] != 0 || mask_.layers[index(x, y)] != layer_) continue;
                take_patch(x, y);
                SignContrast sign;
                if (patch_.size() >= least_px && judge(sign)) signs.push_back(sign);
            }
        return signs;
    }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] double luminance(std::size_t at) const {
        const std::uint8_t* pixel = &picture_.pixels[4 * at];
        return red_[pixel[0]] + green_[pixel[1]] + blue_[pixel[2]];
    }
    template <class Visit>
    void visit_near(std::size_t at, int reach, Visit visit) const {
        const int x = static_cast<int>(at % static_cast<std::size_t>(width_)),
                  y = static_cast<int>(at / static_cast<std::size_t>(width_));
        for (int row = std::max(y - reach, 0); row <= std::min(y + reach, height_ - 1); ++row)
            for (int column = std::max(x - reach, 0); column <= std::min(x + reach, width_ - 1); ++column)
                visit(index(column, row));
    }

    /// A layer in front covers what lies beside the pixel.
    [[nodiscard]] bool borders_on_cover(std::size_t pixel) const {
        bool has_cover = false;
        visit_near(pixel, 1, [&](std::size_t at) { has_cover = has_cover || mask_.layers[at] > layer_; });
        return has_cover;
    }

    [[nodiscard]] bool is_at_border(std::size_t pixel) const {
        bool is_one = false;
        visit_near(pixel, 1, [&](std::size_t at) { is_one = is_one || mask_.layers[at] != layer_; });
        return is_one;
    }

    void take_patch(int x, int y) {
        patch_.assign(1, index(x, y));
        taken_[patch_[0]] = 1;
        for (std::size_t n = 0; n < patch_.size(); ++n)
            visit_near(patch_[n], 1, [&](std::size_t at) {
                if (taken_[at] != 0 || mask_.layers[at] != layer_) return;
                taken_[at] = 1;
                patch_.push_back(at);
            });
    }

    [[nodiscard]] perception::PixelRegion box() const {
        perception::PixelRegion box{width_, height_, 0, 0};
        for (const std::size_t at : patch_) {
            const int x = static_cast<int>(at % static_cast<std::size_t>(width_)),
                      y = static_cast<int>(at / static_cast<std::size_t>(width_));
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), std::max(box.bottom, y + 1)};
        }
        return box;
    }

    /// False where it is covered.
    [[nodiscard]] bool judge(SignContrast& sign) {
        ++patches_;
        std::vector<double> own, around;
        std::size_t in_front = 0;
        bool is_edge = true;
        for (const std::size_t pixel : patch_) {
            own.push_back(luminance(pixel));
            is_edge = is_edge && borders_on_cover(pixel);
            if (!is_at_border(pixel)) continue;  // what lies near it lies near one that is
            visit_near(pixel, kSurroundings_px, [&](std::size_t at) {
                if (mask_.layers[at] == layer_ || seen_[at] == patches_) return;
                seen_[at] = patches_;
                in_front += mask_.layers[at] > layer_ ? 1 : 0;
                around.push_back(luminance(at));
            });
        }
        if (is_edge || 2 * in_front > around.size()) return false;
        const Quantiles parts = quantiles(own, kOwnParts);
        sign = {box(), static_cast<std::uint32_t>(patch_.size()), contrast_ratio(parts.low, parts.high)};
        if (!around.empty()) sign.ratio = std::max(sign.ratio, against(parts, quantiles(around, kAroundParts)));
        return true;
    }

    [[nodiscard]] static double against(const Quantiles& parts, const Quantiles& around) {
        double least = contrast_ratio(0, 1);
        for (const double value : {around.low, around.middle, around.high})
            least = std::min(least, std::max(contrast_ratio(parts.low, value), contrast_ratio(parts.high, value)));
        return least;
    }

    const RgbaPicture& picture_;
    const LayerMask& mask_;
    std::uint8_t layer_;
    int width_, height_;
    std::array<double, 256> red_{}, green_{}, blue_{};  ///< shares of the luminance, by a channel's level
    std::vector<std::uint8_t> taken_;
    std::vector<std::uint32_t> seen_;  ///< for which patch, counted from 1, a pixel was counted to the surroundings last
    std::uint32_t patches_ = 0;
    std::vector<std::size_t> patch_;
};

}  // namespace

std::vector<SignContrast> sign_contrasts(const RgbaPicture& picture, const LayerMask& mask, std::uint8_t layer,
                                         std::uint32_t least_px) {
    return PatchReader(picture, mask, layer).read(least_px);
}

}  // namespace tedavis::host_sim
