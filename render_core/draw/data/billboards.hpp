/// Draws the icon and name of a feature above its position (billboard_place.hpp): obstacles, places, runways, samples, models,
/// storms, areas. The label planner (label_planner.hpp) has decided before which features have an icon and a name.
///
/// A size attribute scales the icon between its least and greatest size; without one it has size_m (kIconSize_m by default) at
/// its distance, within the same limits. `link` draws a line down to the ground. No-go areas and airspaces show their limits
/// below the name (area_limits.hpp). Where a sign would cover an earlier one or the symbology, these are tried in order: the
/// name on another side; a longer stem; no name (an airspace keeps its limits); hiding the sign. Signs behind terrain are
/// hidden. Obstacles have no longer stems, which would look like their heights: without room for the name and the stem they are
/// drawn at their position, below the symbology.
///
/// An obstacle's icon is by its kind and its height above the ground (icons.hpp), and has the colour of the alert where it is in
/// the way (obstacle_color.hpp).
///
/// Pure, apart from queries to the ground: for the link, and for an obstacle's height. Bounded.
#pragma once

#include "render_core/draw/data/billboard_shape.hpp"
#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/label_room.hpp"

namespace tedavis::draw {

/// The preferred placement of a sign.
struct BillboardWish {
    SignSide side = SignSide::right;
    std::uint8_t stem = 0;
    const LabelRoom* kept_clear = nullptr;  ///< room reserved for names, except box `own` and those that overlap it
    std::size_t own = LabelRoom::kMax;
};

enum class BillboardFate : std::uint8_t {
    nowhere,  ///< not ahead, of unknown position, or no room in the batches
    no_room,  ///< an earlier sign or the symbology is there
    hidden,   ///< there is room, but terrain hides it
    stands
};
struct BillboardAnswer {
    BillboardFate fate = BillboardFate::nowhere;
    SignSide side = SignSide::none;  ///< none: without a name
    std::uint8_t stem = 0;           ///< index of the stem's length; kSignStems: no stem
    Rect room{};                     ///< the room that it takes, or would take if it were not hidden

    /// A number for the look; 0: not drawn.
    [[nodiscard]] std::uint8_t look() const {
        return fate == BillboardFate::stands ? static_cast<std::uint8_t>(1 + 4 * stem + static_cast<std::uint8_t>(side)) : 0;
    }
};

/// Draws a sign. `shape` is the feature's in the sheet's view, with its name.
[[nodiscard]] BillboardAnswer add_billboard(BillboardSheet& sheet, const ElementInput& input, std::uint32_t feature,
                                            const BillboardShape& shape, const BillboardWish& wish);

}  // namespace tedavis::draw
