#include "host_sim/accuracy/knobs/crowded_signs.hpp"

#include <algorithm>
#include <bitset>

namespace tedavis::host_sim {
namespace {

constexpr float kIconHalf_px = 8, kIconGap_px = 4, kFoot_px = 20, kNameHeight_px = 15;
constexpr double kMinName_px = 40, kMaxName_px = 90;
constexpr std::size_t kMaxPlaces = CrowdedSigns::kCount * std::size(draw::kNameSides) * draw::kSignStems;

using NamePlaces = std::bitset<kMaxPlaces>;

/// All places of all names, and which of them exclude each other.
class PlaceSearch {
public:
    void begin_sign() { of_sign_.emplace_back(); }
    void add(const draw::Rect& room) {
        const std::size_t place = rooms_.size();
        const draw::Rect wide = draw::LabelPlanner::with_margin(room, CrowdedSigns::kInterval.text_px);
        excluded_.emplace_back();
        for (std::size_t n = 0; n < place; ++n)
            if (wide.overlaps(rooms_[n])) excluded_[n].set(place), excluded_[place].set(n);
        rooms_.push_back(room);
        of_sign_.back().set(place);
    }
    [[nodiscard]] std::uint32_t most() {
        best_ = 0;
        NamePlaces all;
        for (std::size_t n = 0; n < rooms_.size(); ++n) all.set(n);
        look(0, 0, all);
        return best_;
    }

private:
    /// How many of the signs from one on have a place left.
    [[nodiscard]] std::uint32_t hopeful(std::size_t sign, const NamePlaces& left) const {
        std::uint32_t count = 0;
        for (std::size_t n = sign; n < of_sign_.size(); ++n) count += (of_sign_[n] & left).any() ? 1 : 0;
        return count;
    }
    void look(std::size_t sign, std::uint32_t named, const NamePlaces& left) {
        best_ = std::max(best_, named);
        if (sign == of_sign_.size() || named + hopeful(sign, left) <= best_) return;
        const NamePlaces mine = of_sign_[sign] & left;
        for (std::size_t place = 0; place < rooms_.size(); ++place)
            if (mine[place]) look(sign + 1, named + 1, left & ~excluded_[place]);
        look(sign + 1, named, left);
    }

    std::vector<draw::Rect> rooms_;
    std::vector<NamePlaces> excluded_, of_sign_;
    std::uint32_t best_ = 0;
};

}  // namespace

CrowdedSigns::CrowdedSigns(SeededRandom& numbers) {
    const draw::Rect& screen = kInterval.screen;
    for (std::uint32_t n = 0; n < kCount; ++n) {
        draw::SignBox box;
        box.middle = {static_cast<float>(numbers.between(0.2, 0.8)) * screen.width,
                      static_cast<float>(numbers.between(0.3, 0.8)) * screen.height};
        box.half_px = kIconHalf_px;
        box.gap_px = kIconGap_px;
        box.foot_px = kFoot_px;
        box.name_width_px = static_cast<float>(numbers.between(kMinName_px, kMaxName_px));
        box.name_height_px = kNameHeight_px;
        boxes_.push_back(box);
    }
}

draw::LabelShape CrowdedSigns::shape(draw::LabelKey key) { return {boxes_[draw::feature_of(key)], true, stems_}; }

std::uint32_t CrowdedSigns::most_names() const {
    PlaceSearch search;
    for (const draw::SignBox& box : boxes_) {
        search.begin_sign();
        for (std::uint8_t stem = 0; stem < draw::kSignStems; ++stem)
            for (const draw::SignSide side : draw::kNameSides) {
                const draw::Rect room = box.raised(stem, kInterval.text_px).with(side);
                if (kInterval.screen.contains(room)) search.add(room);
            }
    }
    return search.most();
}

}  // namespace tedavis::host_sim
