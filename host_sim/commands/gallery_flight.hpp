/// The shipped default flight over the shipped terrain, drawn as a replay draws it.
#pragma once

#include <string>
#include <vector>

#include "host_sim/commands/gallery_moments.hpp"
#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_preroll.hpp"
#include "host_sim/reports/drawn_sheet.hpp"
#include "host_sim/temporary_folder.hpp"

namespace tedavis::host_sim {

/// Builds the files of the flight in a temporary folder, which the destructor removes. Throws UserError and Interrupted.
class GalleryFiles {
public:
    explicit GalleryFiles(Console& console);
    /// Returns `picture` with this terrain, this scene and, where it names no aircraft, the demo's.
    [[nodiscard]] PictureOptions over(PictureOptions picture) const;
    [[nodiscard]] PlayerFiles player(const PictureOptions& picture) const;

private:
    TemporaryFolder folder_;
    std::string terrain_, scene_;
};

/// Draws moments of the flight with one display, in one size. `files` must outlive it.
class GalleryFlight {
public:
    /// Terrain and scene of `picture` are replaced by those of `files`.
    GalleryFlight(const GalleryFiles& files, const PictureOptions& picture);
    /// Without layers. Throws UserError where the flight has no such moment.
    [[nodiscard]] DrawnSheet::Picture draw(const GalleryMoment& moment);
    /// The session, which holds the last picture.
    [[nodiscard]] DisplaySession& session() { return session_; }

private:
    PictureOptions picture_;
    DisplaySession session_;
    FlightPlayer player_;
    FramePreroll preroll_;
    std::vector<PhaseSpan> spans_;
};

}  // namespace tedavis::host_sim
