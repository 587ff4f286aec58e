#include "render_core/draw/symbology/short_words.hpp"

namespace tedavis::draw {
namespace {

constexpr ShortWording kShortWordings[] = {
    // References, and what is old.
    {"HDG TRUE", "HDG T"},
    {"HDG MAG", "HDG M"},
    {"TRK TRUE", "TRK T"},
    {"FT/MIN", "FPM"},
    {"STALE", "OLD"},
    // The flight phase and its source.
    {"TAKEOFF FIRST CLIMB", "FIRST CLIMB"},
    {"TAKEOFF SECOND CLIMB", "SECOND CLIMB"},
    {"GO AROUND REPLANNING", "REPLANNING"},
    {"PHASE BY SWITCH", "BY SWITCH"},
    {"PHASE FROM MOTION", "FROM MOTION"},
    {"PHASE NO SOURCE", "NO SOURCE"},
    // Notices.
    {"GPS POSITION STALE", "GPS POS STALE"},
    {"PHASE SWITCH FAULT", "PHASE SW FAULT"},
    {"DATABASE NOT YET VALID", "DB NOT YET VALID"},
    {"TRAFFIC INCOMPLETE", "TFC INCOMPLETE"},
    {"NO TERRAIN IMAGE", "NO IMAGE"},
    {"ORTHOGRAPHIC VIEW", "ORTHO VIEW"},
    {"FLAT - NO RELIEF", "NO RELIEF"},
    {"GRAPHICS REDUCED", "REDUCED"},
    {"GENERATED FLIGHT", "GENERATED"},
};

}  // namespace

base::Span<const ShortWording> short_wordings() noexcept { return kShortWordings; }

std::string_view short_wording(std::string_view whole) noexcept {
    for (const ShortWording& row : kShortWordings)
        if (row.whole == whole) return row.shorter;
    return whole;
}

Words short_words(std::string_view whole) noexcept { return {whole, short_wording(whole)}; }

Words short_words_or_none(std::string_view whole) noexcept { return {whole, short_wording(whole), ""}; }

}  // namespace tedavis::draw
