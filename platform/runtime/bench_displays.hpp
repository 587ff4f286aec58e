/// Port: what a program provides to the bench that measures the costs of its display: its designs, how its displays are started
/// and drawn, and its clock. `tedavis` and `tedavis-display` differ only in these; both measure with
/// platform/runtime/cost_bench.hpp.
///
/// Thread  one. Failure  messages; none of the functions may throw.
#pragma once

#include <memory>

#include "platform/runtime/display_host.hpp"
#include "render_core/effects/calibration_text.hpp"
#include "render_core/flight/posed_state.hpp"

namespace tedavis::platform {

/// The pose of the frames that are timed, and the time at which data are shown.
struct BenchPlace {
    flight::StatedPose pose;
    base::Time time;
};

/// What one display is started with.
struct BenchPicture {
    base::FixedString<127> name;  ///< of the design
    design::DesignSettings design;
    bool has_terrain = true, has_scene = true;
};

/// States why there is no picture; empty: there is one.
using BenchNote = base::FixedString<127>;

class BenchDisplays {
public:
    virtual ~BenchDisplays() = default;

    /// Writes the picture with the design whose costs are measured.
    virtual void own_picture(BenchPicture& picture) const = 0;
    /// Writes a picture that requests an effect, by its design or because the effect was added to the design.
    [[nodiscard]] virtual BenchNote picture_with(effects::Effect effect, BenchPicture& picture) const = 0;
    /// Writes a picture that shows elements, or no elements besides glyphs.
    [[nodiscard]] virtual BenchNote picture_with(effects::Overhead overhead, BenchPicture& picture) const = 0;
    /// The number of pictures over which quality levels are measured, at least one; quality_picture() numbers them from 0.
    [[nodiscard]] virtual std::size_t quality_pictures() const = 0;
    virtual void quality_picture(std::size_t n, BenchPicture& picture) const = 0;

    /// Starts a display, whose surface is current then. The error says what could not be started.
    [[nodiscard]] virtual base::Error open(const BenchPicture& picture, std::unique_ptr<DisplayHost>& host) = 0;
    /// Draws the planned frame as the program does in flight, and waits until it is drawn. Returns false where the surface is
    /// lost.
    [[nodiscard]] virtual bool draw(DisplayHost& host) = 0;

    [[nodiscard]] virtual base::Time now() const = 0;
    /// True once the user has stopped the program: the bench then ends after the frame.
    [[nodiscard]] virtual bool is_stopped() const = 0;
    virtual void progress(std::size_t done, std::size_t total) = 0;
};

}  // namespace tedavis::platform
