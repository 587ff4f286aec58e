#include "render_core/policy/notice_table.hpp"

#include "render_core/base/check.hpp"

namespace tedavis::policy {
namespace {

constexpr NoticeLevel kWarning = NoticeLevel::warning, kCaution = NoticeLevel::caution, kInformation = NoticeLevel::information;
constexpr RecordFlag kNoFlag = RecordFlag::count_;
constexpr std::string_view kNothingRemoved = "Nothing is removed.",
                           kTerrainRemoved = "The terrain and its warning colors are removed.";

/// In the order of the ids.
constexpr NoticeRow kNoticeRows[] = {
    {NoticeId::terrain_failed, kWarning, "TERRAIN FAIL", RecordFlag::terrain_failed,
     "The terrain database cannot be read, or has failed its checks.", kTerrainRemoved,
     "The pilot flies by the other instruments, and maintenance renews the database."},
    {NoticeId::below_terrain_flying, kWarning, "BELOW TERRAIN", RecordFlag::terrain_above_own_ship,
     "The own ship flies, and its height is below the database's surface.",
     "The terrain is removed, and the plain horizon is grey over red.",
     "The pilot climbs, and compares the height with other instruments."},
    {NoticeId::terrain_ahead_warning, kWarning, "TERRAIN AHEAD", RecordFlag::terrain_ahead,
     "The predicted track comes too close to terrain within 30 s.", kNothingRemoved, "The pilot climbs or turns away at once."},
    {NoticeId::obstacle_ahead_warning, kWarning, "OBSTACLE AHEAD", RecordFlag::obstacle_ahead,
     "The predicted track comes too close to an obstacle within 30 s.", kNothingRemoved,
     "The pilot climbs or turns away at once."},
    {NoticeId::terrain_ahead_caution, kCaution, "TERRAIN AHEAD", RecordFlag::terrain_ahead,
     "The predicted track comes too close to terrain within 60 s.", kNothingRemoved, "The pilot corrects the flight path."},
    {NoticeId::obstacle_ahead_caution, kCaution, "OBSTACLE AHEAD", RecordFlag::obstacle_ahead,
     "The predicted track comes too close to an obstacle within 60 s.", kNothingRemoved, "The pilot corrects the flight path."},
    {NoticeId::position_stale, kCaution, "GPS POSITION STALE", RecordFlag::own_ship_stale,
     "The last position is older than the limit of fresh positions.", kTerrainRemoved,
     "The pilot navigates by other means, and maintenance examines the GPS receiver."},
    {NoticeId::no_position, kCaution, "NO GPS POSITION", kNoFlag, "The position is missing, lost or invalid.", kTerrainRemoved,
     "The pilot navigates by other means, and maintenance examines the GPS receiver."},
    {NoticeId::no_terrain_data, kCaution, "NO TERRAIN DATA", RecordFlag::terrain_missing, "No terrain database was given.",
     kTerrainRemoved, "Maintenance loads a terrain database."},
    {NoticeId::outside_database, kCaution, "OUTSIDE DATABASE", RecordFlag::terrain_outside_database,
     "The own ship is outside the area of the terrain database.", kTerrainRemoved,
     "The pilot expects no terrain and no terrain alert here."},
    {NoticeId::below_terrain_parked, kCaution, "BELOW TERRAIN", RecordFlag::terrain_above_own_ship,
     "The own ship is slower than 15 m/s, and at most 30 m below the database's surface.", kTerrainRemoved,
     "The pilot compares the height with that of the airport."},
    {NoticeId::terrain_degraded, kCaution, "TERRAIN DEGRADED", RecordFlag::terrain_degraded,
     "The position or the height is not reliable.", "The warning colors are removed.",
     "The pilot does not judge clearances by the terrain of the picture."},
    {NoticeId::terrain_coarse, kCaution, "TERRAIN COARSE", RecordFlag::terrain_coarse,
     "Budgets leave the terrain with a larger error than the design allows.", kNothingRemoved,
     "The pilot does not judge small clearances by the terrain of the picture."},
    {NoticeId::terrain_off, kCaution, "TERRAIN OFF", kNoFlag,
     "A signal that the terrain needs is not valid, or the device cannot draw the terrain accurately enough.", kTerrainRemoved,
     "The pilot flies by the other instruments, and maintenance reads the flags of the record."},
    {NoticeId::map_north_up, kCaution, "MAP NORTH UP", RecordFlag::map_north_up,
     "The map is track up, and neither track nor heading is valid.", "The map no longer turns with the track.",
     "The pilot reads directions from the map's north arrow."},
    {NoticeId::minimums, kCaution, "MINIMUMS", kNoFlag, "The own ship is at or below the minimum of the approach.",
     kNothingRemoved, "The pilot goes around if the runway is not in sight."},
    {NoticeId::phase_switch_fault, kCaution, "PHASE SWITCH FAULT", RecordFlag::phase_switch_fault,
     "The phase switches have an impossible pattern.", kNothingRemoved,
     "The pilot expects the design of the last valid phase, and maintenance examines the switches."},
    {NoticeId::phase_disagreement, kCaution, "PHASE DISAGREE", RecordFlag::phase_disagreement,
     "Two sources state different flight phases.", kNothingRemoved,
     "The pilot sets the phase switches to the phase that is flown."},
    {NoticeId::database_expired, kCaution, "DATABASE EXPIRED", RecordFlag::database_out_of_date,
     "The last day on which the databases may be used is over.", kNothingRemoved,
     "The pilot compares what is shown with current charts, and maintenance loads current databases."},
    {NoticeId::database_not_yet_valid, kCaution, "DATABASE NOT YET VALID", RecordFlag::database_out_of_date,
     "The first day on which the databases may be used has not begun.", kNothingRemoved,
     "The pilot compares what is shown with current charts, and maintenance loads current databases."},
    {NoticeId::data_out_of_date, kCaution, "DATA OUT OF DATE", RecordFlag::data_out_of_date,
     "Data that the design shows are not valid at this time.", "These data are removed.", "Maintenance loads current data."},
    {NoticeId::data_stale, kCaution, "DATA STALE", RecordFlag::data_stale,
     "Data that the design shows are older than their limit.", kNothingRemoved,
     "The pilot takes the data for old ones; the whole legend names them with their age."},
    {NoticeId::analysis_overlay, kCaution, "ANALYSIS OVERLAY", kNoFlag,
     "Colors show a measure of the picture, its saliency or its clutter.", kNothingRemoved,
     "The observer does not take these colors for terrain or data."},
    {NoticeId::traffic_incomplete, kCaution, "TRAFFIC INCOMPLETE", RecordFlag::traffic_cut,
     "More aircraft are received than the display can hold.", "Some of these aircraft are removed.",
     "The pilot looks out for aircraft that the display does not show."},
    {NoticeId::database_ends, kInformation, "DATABASE ENDS", RecordFlag::terrain_ends,
     "The predicted track leaves the area of the terrain database within 60 s.", kNothingRemoved,
     "The pilot expects no terrain and no terrain alert beyond the hatched edge."},
    {NoticeId::no_terrain_image, kInformation, "NO TERRAIN IMAGE", RecordFlag::terrain_no_image,
     "The database or the device does not have the image over the terrain.", "The image is removed.",
     "Maintenance loads a database with an image."},
    {NoticeId::orthographic_view, kInformation, "ORTHOGRAPHIC VIEW", kNoFlag,
     "The picture is the orthographic view, in which near and far lengths are alike.", kNothingRemoved,
     "The pilot does not take the picture for the view ahead."},
    {NoticeId::flat_ground, kInformation, "FLAT - NO RELIEF", RecordFlag::terrain_flat,
     "The design draws the ground without relief.", "The relief of the terrain is removed.",
     "The pilot does not judge clearances by the picture."},
    {NoticeId::graphics_reduced, kInformation, "GRAPHICS REDUCED", kNoFlag,
     "The picture is reduced so that the frame meets its deadline.", "Effects and details that the record names are removed.",
     "The pilot does nothing."},
    {NoticeId::generated_flight, kInformation, "GENERATED FLIGHT", kNoFlag, "The flight comes from a scenario.", kNothingRemoved,
     "The observer does not take the flight for a real one."},
    {NoticeId::not_for_navigation, kInformation, "NOT FOR NAVIGATION", kNoFlag, "This notice is always shown.", kNothingRemoved,
     "The pilot navigates by certified instruments."},
};
static_assert(sizeof kNoticeRows / sizeof kNoticeRows[0] == kNoticeCount);
constexpr bool notice_rows_in_order() {
    for (std::size_t i = 0; i < kNoticeCount; ++i)
        if (kNoticeRows[i].id != static_cast<NoticeId>(i)) return false;
    return true;
}
static_assert(notice_rows_in_order());

}  // namespace

base::Span<const NoticeRow> notice_rows() noexcept { return base::Span<const NoticeRow>(kNoticeRows); }

const NoticeRow& notice_row(NoticeId id) noexcept {
    const auto index = static_cast<std::size_t>(id);
    TEDAVIS_CHECK(index < kNoticeCount);
    return kNoticeRows[index];
}

}  // namespace tedavis::policy
