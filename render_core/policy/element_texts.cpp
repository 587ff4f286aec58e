#include "render_core/policy/element_texts.hpp"

#include <cstddef>

#include "render_core/base/check.hpp"

namespace tedavis::policy {
namespace {

constexpr std::string_view kElementNames[] = {"attitude",
                                              "heading",
                                              "airspeed",
                                              "altitude",
                                              "vertical_speed",
                                              "baro_setting",
                                              "ground_height",
                                              "flight_path",
                                              "position",
                                              "map_up",
                                              "wind",
                                              "outside_temperature",
                                              "slip",
                                              "turn_rate",
                                              "flaps",
                                              "navigation_source",
                                              "course",
                                              "lateral_deviation",
                                              "vertical_deviation",
                                              "waypoint_bearing",
                                              "flight_path_reference",
                                              "flight_director",
                                              "selected_altitude",
                                              "selected_heading",
                                              "selected_airspeed",
                                              "selected_vertical_speed",
                                              "airspeed_trend",
                                              "radio_minimum",
                                              "baro_minimum"};
static_assert(sizeof kElementNames / sizeof kElementNames[0] == kElementCount);
constexpr std::string_view kShowNames[] = {"normal", "substituted", "flagged", "failed", "absent"};

constexpr ElementShow kNormal = ElementShow::normal, kSubstituted = ElementShow::substituted, kFlagged = ElementShow::flagged,
                      kFailedShow = ElementShow::failed;
constexpr TextColor kRed = TextColor::red, kAmber = TextColor::amber;
constexpr std::string_view kNothingGone = "Nothing is removed.", kLastStays = "The last value stays in amber.",
                           kValueGone = "A red cross replaces the value.";

constexpr ElementText kElementTexts[] = {
    {"attitude", kNormal, kAmber, "BANK",
     "The bank exceeds the limit of the aircraft, which is 45 degrees without an aircraft file.", kNothingGone},
    {"attitude", kFlagged, kAmber, "ATTITUDE STALE, FD", "Pitch or bank is stale.",
     "The terrain is removed, and the last attitude stays."},
    {"attitude", kFailedShow, kRed, "ATTITUDE FAIL", "Pitch or bank is not valid.",
     "A red cross replaces the attitude, and the terrain is removed."},
    {"heading", kNormal, kAmber, "VAR", "The heading is magnetic, and the magnetic variation is not valid.",
     "The rose loses its marks of true directions, and without a track the terrain of the 3D view is removed."},
    {"heading", kSubstituted, kAmber, "TRK TRUE, HDG", "No heading is valid, and the track is.",
     "The track replaces the heading."},
    {"heading", kFlagged, kAmber, "HDG TRUE, HDG MAG, TRK TRUE, #, STALE", "The heading, or the track in its place, is stale.",
     "The terrain of the 3D view is removed, and the last value stays in amber."},
    {"heading", kFailedShow, kRed, "HDG FAIL", "Neither heading nor track is valid.",
     "A red cross replaces the rose, and the terrain of the 3D view is removed."},
    {"airspeed", kSubstituted, kAmber, "TAS KT, GS KT", "Neither indicated nor calibrated airspeed is valid.",
     "The speed that the text names replaces the airspeed, and the speed bands are removed."},
    {"airspeed", kFlagged, kAmber, "IAS KT, CAS KT, TAS KT, GS KT, #, STALE", "The speed that the text names is stale.",
     kLastStays},
    {"airspeed", kFailedShow, kRed, "SPD FAIL", "No speed is valid.", "A red cross replaces the tape."},
    {"altitude", kSubstituted, kAmber, "GPS MSL FT, STD FT", "The altitude on the altimeter's setting is not valid.",
     "The altitude that the text names replaces it, and the bugs are removed from the scale."},
    {"altitude", kFlagged, kAmber, "BARO FT, GPS MSL FT, STD FT, #, STALE", "The altitude that the text names is stale.",
     "The terrain is removed, and the last value stays in amber."},
    {"altitude", kFailedShow, kRed, "ALT FAIL", "No altitude is valid.",
     "A red cross replaces the tape, and the terrain is removed."},
    {"vertical_speed", kFlagged, kAmber, "#, STALE", "The vertical speed is stale.", kLastStays},
    {"vertical_speed", kFailedShow, kRed, "VS FAIL", "The vertical speed is not valid.", "A red cross replaces the scale."},
    {"baro_setting", kFlagged, kAmber, "STALE QNH HPA, #", "The altimeter setting is stale.", kLastStays},
    {"baro_setting", kFailedShow, kRed, "BARO SET FAIL", "The altimeter setting is not valid.", kValueGone},
    {"ground_height", kSubstituted, kAmber, "AGL FT",
     "The height above the terrain database is shown while the terrain is degraded.", kNothingGone},
    {"ground_height", kFlagged, kAmber, "STALE RA FT, STALE AGL FT, STALE AGL, #", "The height that the text names is stale.",
     kLastStays},
    {"ground_height", kFailedShow, kRed, "AGL FAIL", "No height above ground is valid.", kValueGone},
    {"flight_path", kFailedShow, kAmber, "FPV", "The position, the attitude or the heading is not valid.",
     "The flight-path vector is removed."},
    {"position", kFlagged, kAmber, "POSITION STALE", "The position is stale.",
     "The terrain is removed, and the own ship stays on the map in amber."},
    {"position", kFailedShow, kRed, "NO POSITION", "The position is not valid.", "A red cross replaces the symbols of the map."},
    {"map_up", kSubstituted, kAmber, "HDG UP, HDG#", "The track is not valid, and the heading is at the top of the map.",
     "The map no longer turns with the track."},
    {"map_up", kFlagged, kAmber, "NORTH UP, NORTH#", "Neither track nor heading is valid, and north is at the top of the map.",
     "The map no longer turns."},
    {"wind", kFlagged, kAmber, "#/#KT #S, CALM #S", "The wind is stale, and the last number is its age.", kLastStays},
    {"wind", kFailedShow, kAmber, "WIND", "The wind is not valid.", kValueGone},
    {"outside_temperature", kFlagged, kAmber,
     "OAT #\xC2\xB0"
     "C #S",
     "The temperature is stale, and the last number is its age.", kLastStays},
    {"outside_temperature", kFailedShow, kAmber, "OAT", "The temperature is not valid.", kValueGone},
    {"slip", kFlagged, kAmber, "STALE", "The lateral acceleration is stale.", kLastStays},
    {"slip", kFailedShow, kAmber, "SLIP", "The lateral acceleration is not valid.", kValueGone},
    {"turn_rate", kFlagged, kAmber, "TURN, STALE", "The turn rate is stale.", kLastStays},
    {"turn_rate", kFailedShow, kAmber, "TURN", "The turn rate is not valid.",
     "The trend of the turn is removed, and the name has a red cross."},
    {"course", kFlagged, kAmber, "CRS #, LOC#, GPS, STALE", "The course, or the statement of its source, is stale.", kLastStays},
    {"course", kFailedShow, kAmber, "CRS", "The course, or the statement of its source, is not valid.",
     "The course needle is removed, and a red cross replaces the course."},
    {"lateral_deviation", kFlagged, kAmber, "LOC#, GPS, TERM, APR, ENR, STALE",
     "The lateral deviation, or the statement of its source, is stale.", kLastStays},
    {"lateral_deviation", kFailedShow, kAmber, "LOC, GPS, NAV", "The lateral deviation, or (NAV) the source, is not valid.",
     "A red cross replaces the deviation bar."},
    {"vertical_deviation", kFlagged, kAmber, "GS, GP, STALE", "The vertical deviation, or the statement of its source, is stale.",
     kLastStays},
    {"vertical_deviation", kFailedShow, kAmber, "GS, GP, NAV", "The vertical deviation, or (NAV) the source, is not valid.",
     "A red cross replaces the scale."},
    {"waypoint_bearing", kFlagged, kAmber, "BRG #, STALE", "The bearing is stale.", kLastStays},
    {"waypoint_bearing", kFailedShow, kAmber, "BRG", "The bearing is not valid.",
     "The bearing pointer is removed, and a red cross replaces the value."},
    {"flight_path_reference", kFlagged, kAmber, "#\xC2\xB0, PATH STALE", "The selected glide path is stale.", kLastStays},
    {"flight_path_reference", kFailedShow, kAmber, "PATH", "The selected glide path is not valid.",
     "The reference of the flight path is removed."},
    {"flight_director", kFlagged, kAmber, "FD STALE", "A signal of the flight director is stale.", "The bars stay in amber."},
    {"flight_director", kFailedShow, kAmber, "FD", "A signal of the flight director is not valid.", "The bars are removed."},
    {"selected_altitude", kFlagged, kAmber, "#", "The selected altitude is stale.", kLastStays},
    {"selected_altitude", kFailedShow, kAmber, "ALT SEL", "The selected altitude is not valid.", kValueGone},
    {"selected_heading", kFlagged, kAmber, "SEL #, STALE", "The selected heading is stale.", kLastStays},
    {"selected_heading", kFailedShow, kAmber, "SEL", "The selected heading is not valid.",
     "The heading bug is removed, and a red cross replaces the value."},
    {"selected_airspeed", kFlagged, kAmber, "#", "The selected airspeed is stale.", kLastStays},
    {"selected_airspeed", kFailedShow, kAmber, "SPD SEL", "The selected airspeed is not valid.", kValueGone},
    {"selected_vertical_speed", kFlagged, kAmber, "#", "The selected vertical speed is stale.", kLastStays},
    {"selected_vertical_speed", kFailedShow, kAmber, "VS SEL", "The selected vertical speed is not valid.", kValueGone},
    {"radio_minimum", kNormal, kAmber, "DH, #", "The own ship is at or below the decision height.", kNothingGone},
    {"radio_minimum", kFlagged, kAmber, "DH, #", "The decision height is stale.", kLastStays},
    {"radio_minimum", kFailedShow, kAmber, "DH", "The decision height is not valid.", kValueGone},
    {"baro_minimum", kNormal, kAmber, "MIN #", "The own ship is at or below the minimum.", kNothingGone},
    {"baro_minimum", kFlagged, kAmber, "MIN #", "The minimum altitude is stale.", kLastStays},
    {"baro_minimum", kFailedShow, kAmber, "MIN", "The minimum altitude is not valid, or lies below the ground.", kValueGone},
    {"phase", kNormal, kAmber, "(phase), PHASE HELD, PHASE NO SOURCE", "No source states the flight phase.",
     "The last phase is held for a while, and no phase is known afterwards."},
    {"distortion", kNormal, kAmber, "DISTORTED, DISTORTED #x", "A part of the map is magnified.", kNothingGone},
    {"legend", kFlagged, kAmber, "(title), #:#Z, STALE # MIN, STALE # H, STALE # D",
     "The data of the entry are older than their limit.", "The data stay with their age in amber."},
    {"legend", kNormal, kAmber, "#:#Z AGE ?", "The bus does not state the time, or no longer does.",
     "The age of the data is removed."},
    {"legend", kNormal, kAmber, "+#", "There is no room for so many entries.", "The last entries are counted only."},
    {"notices", kNormal, kAmber, "+# MORE", "There is no room for so many notices.",
     "The least urgent notices are counted only."},
};

}  // namespace

std::string_view name_of(Element element) noexcept {
    const auto index = static_cast<std::size_t>(element);
    TEDAVIS_CHECK(index < kElementCount);
    return kElementNames[index];
}

std::string_view name_of(ElementShow show) noexcept { return kShowNames[static_cast<std::size_t>(show)]; }

base::Span<const ElementText> element_texts() noexcept { return base::Span<const ElementText>(kElementTexts); }

}  // namespace tedavis::policy
