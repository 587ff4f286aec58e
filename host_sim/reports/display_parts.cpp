#include "host_sim/reports/display_parts.hpp"

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/activity_mark.hpp"
#include "render_core/draw/symbology/bank_scale.hpp"
#include "render_core/draw/symbology/compass_rose.hpp"
#include "render_core/draw/symbology/flight_director.hpp"
#include "render_core/draw/symbology/ladder_frame.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/draw/symbology/tape_marks.hpp"

namespace tedavis::host_sim {
namespace {

using base::kMetresPerFoot;
using base::kMpsPerKnot;
using base::radians;
using draw::Point;
using draw::Rect;
using Drawn = DrawnSymbology;

constexpr float kAirspeedSpan_kt = 100, kAltitudeSpan_ft = 1000;  // of a whole scale

float text_px(const Drawn& drawn) { return drawn.layout.text_px; }
Point middle_of(const Rect& box) { return box.center(); }
/// A point moved by texts.
Point off(const Drawn& drawn, Point from, float x, float y) { return {from.x + x * text_px(drawn), from.y + y * text_px(drawn)}; }
/// In shares of a box.
Point in(const Rect& box, float x, float y) { return {box.x + x * box.width, box.y + y * box.height}; }

/// The moving part of a tape between its rows of text.
Rect scale_of(const Drawn& drawn, const Rect& box, int rows_above, int rows_below) {
    const float row = draw::kTapeRowHeight * text_px(drawn), above = row * static_cast<float>(rows_above);
    return {box.x, box.y + above, box.width, box.height - above - row * static_cast<float>(rows_below)};
}
Rect airspeed_scale(const Drawn& drawn) { return scale_of(drawn, drawn.layout.airspeed, 2, 0); }
Rect altitude_scale(const Drawn& drawn) { return scale_of(drawn, drawn.layout.altitude, 2, 1); }

/// At the ticks of the airspeed tape, `kt` from its value; inwards from its right edge in texts.
Point at_airspeed(const Drawn& drawn, double mps, float inset) {
    const Rect scale = airspeed_scale(drawn);
    const auto off_kt = static_cast<float>((mps - drawn.input.airspeed_mps) / kMpsPerKnot);
    return {scale.right() - (draw::kFlagWidth + inset) * text_px(drawn),
            scale.center().y - off_kt / kAirspeedSpan_kt * scale.height};
}
Point at_altitude(const Drawn& drawn, double m, float inset) {
    const Rect scale = altitude_scale(drawn);
    const auto off_ft = static_cast<float>((m - drawn.input.altitude_m) / kMetresPerFoot);
    return {scale.x + inset * text_px(drawn), scale.center().y - off_ft / kAltitudeSpan_ft * scale.height};
}
Point toward(const Drawn& drawn, double direction_rad, double elevation_deg) {
    return project(drawn.input.view, draw::direction_of(direction_rad, radians(elevation_deg))).at;
}
Point on_bank_scale(const Drawn& drawn, double angle_deg, float inwards) {
    const Point center = drawn.layout.screen.center();
    const float radius = draw::bank_scale_radius(drawn.layout) - inwards * text_px(drawn);
    const auto x = static_cast<float>(std::sin(radians(angle_deg))), y = static_cast<float>(std::cos(radians(angle_deg)));
    return {center.x + radius * x, center.y - radius * y};
}
Point on_rose(const Drawn& drawn, double true_rad, float share) {
    const draw::CompassRose rose = draw::make_compass_rose(drawn.layout);
    return rose.at(draw::rose_angle_rad(drawn.input, true_rad), share * rose.radius);
}
Point beside_rose(const Drawn& drawn, draw::RoseSide side, int row) {
    return in(draw::make_compass_rose(drawn.layout).side_row(side, row), side == draw::RoseSide::left ? 0.0f : 1.0f, 0.5f);
}

const DisplayPart kParts[] = {
    {"flight phase", "The phase and its source. The phase decides what comes first in the picture.",
     [](const Drawn& drawn) {
         return Point{drawn.layout.annunciations.x + 8 * text_px(drawn), drawn.layout.annunciations.center().y};
     }},
    {"warnings and cautions", "What is wrong or needs attention, the most urgent first: warnings are red, cautions amber.",
     [](const Drawn& drawn) { return in(drawn.layout.annunciations, 0.6f, 0.5f); }},
    {"activity mark",
     "The hand moves with each new position, and goes round in seven seconds; it stands still where no position comes, or where "
     "the display has stopped.",
     [](const Drawn& drawn) { return draw::activity_mark_box(drawn.layout.annunciations, text_px(drawn)).center(); }},
    {"information", "Where the flight and the data come from.",
     [](const Drawn& drawn) { return off(drawn, middle_of(drawn.layout.information), -9.3f, 0); }},
    {"selected airspeed", "The airspeed that the pilot has selected (cyan).",
     [](const Drawn& drawn) {
         return Point{drawn.layout.airspeed.x + 0.4f * text_px(drawn), drawn.layout.airspeed.y + 0.7f * text_px(drawn)};
     }},
    {"airspeed tape", "The airspeed by the source that the label names: IAS, CAS or TAS, or GS where there is no airspeed.",
     [](const Drawn& drawn) { return in(airspeed_scale(drawn), 0.08f, 0.1f); }},
    {"airspeed", "The present value; its last digit rolls.",
     [](const Drawn& drawn) { return in(airspeed_scale(drawn), 0.05f, 0.5f); }},
    {"airspeed bug", "The selected airspeed on the scale.",
     [](const Drawn& drawn) { return at_airspeed(drawn, drawn.input.guidance.selected_airspeed_mps, 0.2f); }},
    {"airspeed trend", "The airspeed in six seconds at the present rate.",
     [](const Drawn& drawn) {
         return at_airspeed(drawn, drawn.input.airspeed_mps + 6 * drawn.input.guidance.airspeed_rate_mps2, draw::kTrendInset);
     }},
    {"speed bands",
     "Ranges by the aircraft file, the setting of the flaps and the load factor: red and amber low speeds, green, white where "
     "flaps may be out, a pole or red above the limit.",
     [](const Drawn& drawn) { return off(drawn, in(airspeed_scale(drawn), 1, 0.85f), -draw::kFlagWidth - 0.2f, 0); }},
    {"bank scale", "Ticks at 10, 20, 30, 45 and 60 degrees; the pointer is amber, with BANK, beyond the aircraft's limit.",
     [](const Drawn& drawn) { return on_bank_scale(drawn, -30, 0); }},
    {"slip", "The bar below the pointer moves as the ball of a slip indicator does.",
     [](const Drawn& drawn) {
         const double sky_rad = -drawn.input.roll_rad, widths = -drawn.input.guidance.slip_mps2 / draw::kSlipWidth_mps2;
         const Point up{static_cast<float>(std::sin(sky_rad)), -static_cast<float>(std::cos(sky_rad))};
         return draw::along_and_across(on_bank_scale(drawn, base::degrees(sky_rad), 1.4f), up, 0,
                                       1.3f * static_cast<float>(widths) * text_px(drawn));
     }},
    {"pitch ladder", "The nose's angle above the horizon, a rung every 2.5, 5 and 10 degrees.",
     [](const Drawn& drawn) { return toward(drawn, drawn.input.view_heading_rad + radians(-3), 10); }},
    {"horizon line", "Level, across the whole display, over terrain and sky.",
     [](const Drawn& drawn) { return toward(drawn, drawn.input.view_heading_rad + radians(-16), 0); }},
    {"heading on the horizon", "Directions of the rose's reference: ticks at 10, numbers at 30 degrees.",
     [](const Drawn& drawn) { return toward(drawn, radians(30), 0); }},
    {"aircraft symbol", "Where the nose points.", [](const Drawn& drawn) { return drawn.layout.screen.center(); }},
    {"flight-path vector", "Where the aircraft flies to, by the GPS receiver; the air's motion included.",
     [](const Drawn& drawn) {
         const draw::SymbologyInput& input = drawn.input;
         const double track_rad = std::atan2(input.velocity_east_mps, input.velocity_north_mps);
         const double speed_mps = std::hypot(input.velocity_east_mps, input.velocity_north_mps);
         return toward(drawn, track_rad, base::degrees(std::atan2(input.velocity_up_mps, speed_mps)));
     }},
    {"flight director", "The level bar says by how much the nose, the upright bar by how much the bank must change.",
     [](const Drawn& drawn) {
         const Point center = drawn.layout.screen.center();
         return Point{
             center.x + draw::kBarTexts_per_rad * static_cast<float>(drawn.input.guidance.director_roll_rad) * text_px(drawn),
             center.y - 3.2f * text_px(drawn)};
     }},
    {"glide path", "The selected glide path below the horizon: the flight-path vector lies between its dashes when it is flown.",
     [](const Drawn& drawn) {
         return toward(drawn, drawn.input.view_heading_rad + radians(4), -base::degrees(drawn.input.guidance.path_reference_rad));
     }},
    {"wind", "Measured by the own aircraft: from where, how strong; the arrow points where it blows.",
     [](const Drawn& drawn) { return in(drawn.layout.air, 0.98f, 0.25f); }},
    {"outside temperature", "Measured by the own aircraft.",
     [](const Drawn& drawn) { return in(drawn.layout.air, 0.95f, 0.75f); }},
    {"field of view", "The angle that the picture shows across its width.",
     [](const Drawn& drawn) { return in(draw::field_of_view_box(drawn.layout), 0.9f, 0.5f); }},
    {"deviation from the glide path",
     "Where the path is, up to two dots above or below: a diamond for a radio receiver (green), "
     "a chevron for GNSS (magenta).",
     [](const Drawn& drawn) { return in(drawn.layout.vertical_deviation, 0.5f, 0.5f); }},
    {"selected altitude", "The altitude that the pilot has selected (cyan).",
     [](const Drawn& drawn) {
         return Point{drawn.layout.altitude.right() - 0.4f * text_px(drawn), drawn.layout.altitude.y + 0.7f * text_px(drawn)};
     }},
    {"altitude tape", "The altitude by the source that the label names: BARO, GPS MSL or STD.",
     [](const Drawn& drawn) { return in(altitude_scale(drawn), 0.95f, 0.08f); }},
    {"altitude", "The present value; its last two digits roll.",
     [](const Drawn& drawn) { return in(altitude_scale(drawn), 0.98f, 0.5f); }},
    {"altitude bug", "The selected altitude on the scale.",
     [](const Drawn& drawn) { return at_altitude(drawn, drawn.input.guidance.selected_altitude_m, 0.2f); }},
    {"altitude trend", "The altitude in six seconds at the present vertical speed.",
     [](const Drawn& drawn) {
         return at_altitude(drawn, drawn.input.altitude_m + 6 * drawn.input.vertical_speed_mps, draw::kTrendInset);
     }},
    {"minimum on the scale",
     "The minimum of the approach on the altimeter: cyan, white within 100 ft of it, amber at or below it.",
     [](const Drawn& drawn) { return at_altitude(drawn, drawn.input.guidance.baro_minimum_m, 0.2f); }},
    {"minimum", "Its value.",
     [](const Drawn& drawn) {
         const Rect& box = drawn.layout.altitude;
         return Point{box.right() - 0.3f * text_px(drawn), box.bottom() - 0.7f * text_px(drawn)};
     }},
    {"selected vertical speed", "The vertical speed that the pilot has selected (cyan), with a bug on the scale.",
     [](const Drawn& drawn) {
         return Point{drawn.layout.vertical_speed.right() - 0.4f * text_px(drawn),
                      drawn.layout.vertical_speed.y + 0.7f * text_px(drawn)};
     }},
    {"vertical speed", "Pointer and value.",
     [](const Drawn& drawn) {
         const Rect& box = drawn.layout.vertical_speed;
         return Point{box.right() - 0.3f * text_px(drawn), box.bottom() - 1.2f * text_px(drawn)};
     }},
    {"altimeter setting", "The QNH of the altimeter.",
     [](const Drawn& drawn) { return in(drawn.layout.baro_setting, 0.97f, 0.7f); }},
    {"height above ground", "RA: by radio, AGL: above the terrain database.",
     [](const Drawn& drawn) { return in(drawn.layout.ground_height, 0.03f, 0.7f); }},
    {"decision height", "The minimum of the approach above ground, in the colors of the other minimum.",
     [](const Drawn& drawn) { return in(drawn.layout.ground_height, 0.8f, 0.97f); }},
    {"heading", "The present value with its source: HDG TRUE, HDG MAG or TRK TRUE.",
     [](const Drawn& drawn) { return in(draw::make_compass_rose(drawn.layout).readout, 0.5f, 0); }},
    {"compass rose", "Ticks at 5 and 10, names at 30 degrees; it turns under the lubber line.",
     [](const Drawn& drawn) { return on_rose(drawn, radians(90), 0.9f); }},
    {"turn trend",
     "The heading in six seconds at the present rate, with marks at half the standard rate and at the standard rate.",
     [](const Drawn& drawn) { return on_rose(drawn, drawn.input.view_heading_rad + radians(5), 1.04f); }},
    {"heading bug", "The selected heading.",
     [](const Drawn& drawn) { return on_rose(drawn, drawn.input.guidance.selected_heading_rad, 1); }},
    {"track", "Where the aircraft flies to over the ground.",
     [](const Drawn& drawn) { return on_rose(drawn, drawn.input.track_rad, 0.95f); }},
    {"bearing", "The direction of the active waypoint (BRG, cyan).",
     [](const Drawn& drawn) { return beside_rose(drawn, draw::RoseSide::right, 0); }},
    {"course and its source", "The course with the receiver's name: green for radio (LOC1, LOC2), magenta for GNSS (GPS).",
     [](const Drawn& drawn) { return beside_rose(drawn, draw::RoseSide::left, 0); }},
    {"key of scales",
     "In flight, the scales of the picture that do not explain themselves, on 5 % of it at most; the whole legend comes by a "
     "switch, "
     "the bus, a key or an option.",
     [](const Drawn& drawn) { return in(drawn.layout.key.box, 0.98f, 0.5f); }},
    {"course needle and deviation",
     "The needle lies along the course; its middle part moves to where the course is, up to two dots.",
     [](const Drawn& drawn) { return on_rose(drawn, drawn.input.guidance.course_rad, 0.7f); }},
};

}  // namespace

base::Span<const DisplayPart> display_parts() { return base::Span<const DisplayPart>(kParts); }

}  // namespace tedavis::host_sim
