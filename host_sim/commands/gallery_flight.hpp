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

/// Its files, in a folder that goes with it. Throws UserError and Interrupted.
class GalleryFiles {
public:
    explicit GalleryFiles(Console& console);
    /// `picture` over this terrain, with this scene and, where it names none, the demo's aircraft.
    [[nodiscard]] PictureOptions over(PictureOptions picture) const;
    [[nodiscard]] PlayerFiles player(const PictureOptions& picture) const;

private:
    TemporaryFolder folder_;
    std::string terrain_, scene_;
};

/// One display, pictures of one size. `files` must outlive it.
class GalleryFlight {
public:
    /// `picture`: its terrain and scene are those of `files`.
    GalleryFlight(const GalleryFiles& files, const PictureOptions& picture);
    /// Without layers. Throws UserError where the flight has no such moment.
    [[nodiscard]] DrawnSheet::Picture draw(const GalleryMoment& moment);
    /// Holds what was drawn last.
    [[nodiscard]] DisplaySession& session() { return session_; }

private:
    PictureOptions picture_;
    DisplaySession session_;
    FlightPlayer player_;
    FramePreroll preroll_;
    std::vector<PhaseSpan> spans_;
};

}  // namespace tedavis::host_sim
