#include "host_sim/commands/gallery_flight.hpp"

#include <filesystem>

#include "host_sim/commands/own_ground.hpp"
#include "host_sim/options/replay_options.hpp"
#include "host_sim/shipped_files.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kPhaseStep_s = 0.5;
constexpr double kShuttleRadarAccuracy_m = 16;  ///< LE90 that the mission behind the shipped raster was specified to
constexpr const char* kGalleryAircraft = "turboprop";

std::vector<PhaseSpan> phase_spans(FlightPlayer& player) {
    std::vector<PhaseSpan> spans;
    for (base::Time time = player.first(); time <= player.last(); time = time + base::Duration::from_seconds(kPhaseStep_s))
        add_to_spans(player.at(time).phase.phase, time, spans);
    return spans;
}

}  // namespace

GalleryFiles::GalleryFiles(Console& console)
    : terrain_(build_own_terrain({shipped_root() + kOwnRaster, false, kShuttleRadarAccuracy_m}, folder_.path(), console)),
      scene_(build_own_scenario("default", folder_.path(), console)) {}

PictureOptions GalleryFiles::over(PictureOptions picture) const {
    picture.terrain = terrain_;
    picture.scene = scene_;
    if (picture.aircraft.empty()) picture.aircraft = kGalleryAircraft;
    return picture;
}

PlayerFiles GalleryFiles::player(const PictureOptions& picture) const {
    const std::string built = std::filesystem::path(scene_).parent_path().string();
    return {built + "/flight.log", picture.bus, built + "/flight.switches", ReplayOptions().switch_config};
}

GalleryFlight::GalleryFlight(const GalleryFiles& files, const PictureOptions& picture)
    : picture_(files.over(picture)),
      session_(picture_, true),
      player_(files.player(picture_), session_.display()),
      preroll_(player_, session_, session_.device().frame_rate_hz),
      spans_(phase_spans(player_)) {}

DrawnSheet::Picture GalleryFlight::draw(const GalleryMoment& moment) {
    const base::Time time = instant_of(moment, spans_, "the default flight");
    static_cast<void>(preroll_.preroll(time));
    session_.display().plan(player_.at(time));
    session_.draw();
    DrawnSheet::Picture drawn;
    drawn.title = moment.title;
    drawn.caption = moment.caption;
    drawn.file = std::string(moment.name) + ".png";
    drawn.flight_s = (time - player_.first()).to_seconds();
    drawn.design = std::string(session_.display().planned().shown->name.view());
    drawn.result.record = session_.display().record();
    drawn.result.hash = session_.frame_hash();
    drawn.pixels = upright(session_.pixels());
    return drawn;
}

}  // namespace tedavis::host_sim
