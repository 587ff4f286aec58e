/// A few signs on a small part of the screen, and the largest number of their names that can be placed.
#pragma once

#include <utility>
#include <vector>

#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/draw/data/label_planner.hpp"

namespace tedavis::host_sim {

class CrowdedSigns final : public draw::LabelShapes {
public:
    static constexpr std::uint32_t kCount = 8;
    static constexpr draw::LabelInterval kInterval = {1, {0, 0, 220, 130}, 16};

    explicit CrowdedSigns(SeededRandom& numbers);
    /// At most kCount of them.
    explicit CrowdedSigns(std::vector<draw::SignBox> boxes) : boxes_(std::move(boxes)) {}

    /// A name may stand on this many stems: 1 to draw::kSignStems.
    void allow(std::uint8_t stems) { stems_ = stems; }
    /// `key` is the number of a sign, in the first group.
    [[nodiscard]] draw::LabelShape shape(draw::LabelKey key) override;
    /// The greatest number of names that have room at once, with the planner's margins, found by trying all places on all
    /// stems; signs without a name take no room.
    [[nodiscard]] std::uint32_t most_names() const;

private:
    std::vector<draw::SignBox> boxes_;
    std::uint8_t stems_ = draw::kSignStems;
};

}  // namespace tedavis::host_sim
