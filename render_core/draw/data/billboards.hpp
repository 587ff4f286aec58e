/// Icon and name of a feature of a layer, above its place (billboard_place.hpp): obstacles, places, runways, samples, models,
/// storms, areas. Which features have one, and which a name, is decided before (label_planner.hpp).
///
/// A size attribute makes the icon between its least and its greatest size; without one it has size_m (kIconSize_m where the
/// design names none) at its distance, within the same limits. `link` leads a line down to the ground. No-go areas and airspaces
/// have their limits below the name (area_limits.hpp). The name of what would cover one that came before, or the symbology, goes
/// from the side that is wished for to another one, then both up on a longer stem; then it stands without its name (an airspace
/// with its limits alone), then it is hidden; so is what terrain stands before. Obstacles have no longer stems, which would read
/// as their heights: after their names they lose the stem, and stand on the spot, under the symbology. Stems are thin and grey.
///
/// Pure but for the ground that is asked, once for the link. Bounded.
#pragma once

#include "render_core/draw/data/billboard_shape.hpp"
#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/label_room.hpp"

namespace tedavis::draw {

/// Where it should stand, if it has room there.
struct BillboardWish {
    SignSide side = SignSide::right;
    std::uint8_t stem = 0;
    const LabelRoom* kept_clear = nullptr;  ///< of names, but for the box of this number and those that overlap it
    std::size_t own = LabelRoom::kMax;
};

enum class BillboardFate : std::uint8_t {
    nowhere,  ///< not ahead, nothing known of its place, or no room in the batches
    no_room,  ///< what came before it, or the symbology, stands there
    hidden,   ///< there is room, but terrain stands before it
    stands
};
struct BillboardAnswer {
    BillboardFate fate = BillboardFate::nowhere;
    SignSide side = SignSide::none;  ///< none: without a name
    std::uint8_t stem = 0;           ///< number of its length; kSignStems: on the spot
    Rect room{};                     ///< that it takes, or would take if it were not hidden

    /// Tells looks apart; 0: it does not stand.
    [[nodiscard]] std::uint8_t look() const {
        return fate == BillboardFate::stands ? static_cast<std::uint8_t>(1 + 4 * stem + static_cast<std::uint8_t>(side)) : 0;
    }
};

/// `shape`: of this feature in the sheet's view, with the name that it is to have.
[[nodiscard]] BillboardAnswer add_billboard(BillboardSheet& sheet, const ElementInput& input, std::uint32_t feature,
                                            const BillboardShape& shape, const BillboardWish& wish);

}  // namespace tedavis::draw
