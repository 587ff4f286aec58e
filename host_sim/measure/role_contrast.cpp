#include "host_sim/measure/role_contrast.hpp"

#include <algorithm>
#include <cstdlib>

#include "render_core/perception/contrast_ratio.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kBorderParts = 5;
constexpr std::uint8_t kNoRole = 255;

/// The roles of a picture's pixels, and their patches.
class RoleReader {
public:
    RoleReader(const RgbaPicture& picture, const LayerMask& mask, std::uint8_t layer, const design::SymbologyPalette& palette)
        : picture_(picture),
          width_(static_cast<int>(mask.width)),
          height_(static_cast<int>(mask.height)),
          roles_(mask.layers.size(), kNoRole),
          taken_(mask.layers.size(), 0) {
        for (std::size_t at = 0; at < roles_.size(); ++at)
            if (mask.layers[at] == layer) roles_[at] = role_at(at, palette);
    }

    void read(std::uint8_t role, std::uint32_t least_px, std::vector<RoleContrast>& signs) {
        for (std::size_t at = 0; at < roles_.size(); ++at) {
            if (roles_[at] != role || taken_[at] != 0) continue;
            take(at);
            if (patch_.size() < least_px) continue;
            signs.push_back({static_cast<design::SymbolRole>(role), box(), static_cast<std::uint32_t>(patch_.size()), ratio()});
        }
    }

private:
    [[nodiscard]] design::Color color_at(std::size_t at) const {
        const std::uint8_t* pixel = &picture_.pixels[4 * at];
        return {pixel[0], pixel[1], pixel[2]};
    }

    [[nodiscard]] std::uint8_t role_at(std::size_t at, const design::SymbologyPalette& palette) const {
        const design::Color color = color_at(at);
        for (std::size_t role = 0; role < design::kSignRoleCount; ++role) {
            const design::Color wanted = palette.colors[role];
            const int most = std::max(
                {std::abs(color.red - wanted.red), std::abs(color.green - wanted.green), std::abs(color.blue - wanted.blue)});
            if (most <= kRoleTolerance) return static_cast<std::uint8_t>(role);
        }
        return kNoRole;
    }

    template <class Visit>
    void visit_beside(std::size_t at, int reach, Visit visit) const {
        const auto across = static_cast<std::size_t>(width_);
        const int x = static_cast<int>(at % across), y = static_cast<int>(at / across);
        for (int row = std::max(y - reach, 0); row <= std::min(y + reach, height_ - 1); ++row)
            for (int column = std::max(x - reach, 0); column <= std::min(x + reach, width_ - 1); ++column)
                visit(static_cast<std::size_t>(row) * across + static_cast<std::size_t>(column));
    }

    void take(std::size_t first) {
        const std::uint8_t role = roles_[first];
        patch_.assign(1, first);
        taken_[first] = 1;
        for (std::size_t n = 0; n < patch_.size(); ++n)
            visit_beside(patch_[n], 1, [&](std::size_t at) {
                if (taken_[at] != 0 || roles_[at] != role) return;
                taken_[at] = 1;
                patch_.push_back(at);
            });
    }

    [[nodiscard]] perception::PixelRegion box() const {
        const auto across = static_cast<std::size_t>(width_);
        perception::PixelRegion box{width_, height_, 0, 0};
        for (const std::size_t at : patch_) {
            const int x = static_cast<int>(at % across), y = static_cast<int>(at / across);
            box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), std::max(box.bottom, y + 1)};
        }
        return box;
    }

    /// A picture of one role alone has no contrast.
    [[nodiscard]] double ratio() const {
        const std::uint8_t role = roles_[patch_.front()];
        std::vector<double> best;
        for (const std::size_t at : patch_) {
            bool is_border = false;
            visit_beside(at, 1, [&](std::size_t beside) { is_border = is_border || roles_[beside] != role; });
            if (!is_border) continue;
            const double own = relative_luminance(color_at(at));
            double most = 1;
            visit_beside(at, kRimReach_px, [&](std::size_t beside) {
                if (roles_[beside] != role)
                    most = std::max(most, perception::contrast_ratio(own, relative_luminance(color_at(beside))));
            });
            best.push_back(most);
        }
        if (best.empty()) return 1;
        const auto weak = best.begin() + static_cast<std::ptrdiff_t>((best.size() - 1) / kBorderParts);
        std::nth_element(best.begin(), weak, best.end());
        return *weak;
    }

    const RgbaPicture& picture_;
    int width_, height_;
    std::vector<std::uint8_t> roles_;
    std::vector<std::uint8_t> taken_;
    std::vector<std::size_t> patch_;
};

}  // namespace

std::vector<RoleContrast> role_contrasts(const RgbaPicture& picture, const LayerMask& mask, std::uint8_t layer,
                                         const design::SymbologyPalette& palette, std::uint32_t least_px) {
    RoleReader reader(picture, mask, layer, palette);
    std::vector<RoleContrast> signs;
    for (std::size_t role = 0; role < design::kSignRoleCount; ++role)
        reader.read(static_cast<std::uint8_t>(role), least_px, signs);
    return signs;
}

}  // namespace tedavis::host_sim
