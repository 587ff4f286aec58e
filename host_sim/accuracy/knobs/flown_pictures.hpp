/// Pictures of a flight, drawn by the product's own display, on which the knobs that draw with GL are measured.
///
/// A level is a set of options of a picture, among them its device, and a change to its design. Each level has a display of its
/// own, which is started once and stays; the time of its start is build_ms(). Where OSMesa is missing, EGL draws.
///
/// Each pose is drawn without earlier frames: the display's memory of them is reset before each picture, and all terrain has
/// arrived. So a picture does not depend on the order in which pictures are drawn.
///
/// Thread  one. No surface is current between the calls, but from show() to the draw() that follows.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/accuracy/knobs/flown_display.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

/// A value in a device file: that of the first `key` after the first occurrence of `after`, which may be empty.
struct DeviceValue {
    std::string after, key, value;
};

/// Writes a shipped device with other values to a folder; returns its path. Throws UserError where it has no such key.
[[nodiscard]] std::string changed_device(const std::string& folder, const std::string& name, const std::string& shipped,
                                         const std::vector<DeviceValue>& values);

struct FlownLevel {
    PictureOptions picture;
    std::optional<effects::QualityLevel> quality;  ///< quality level of the governor; nothing: as the design requests
    /// Changes the design of the options; it must not request a technique that this design lacks.
    std::function<void(design::DesignSettings&)> change = {};
    /// Adds data of the flight besides the pose, such as air data and other aircraft; empty: none.
    std::function<void(const AircraftPose&, flight::AircraftState&)> complete = {};
    bool has_own_device = false;  ///< the device file is a temporary one
};

/// The whole picture as the display's design has it.
[[nodiscard]] FlownLevel flown_level(const std::string& terrain, const FlownDisplay& display);

/// The terrain with an error of at most `tau_px` on the screen; everything else as in the design.
[[nodiscard]] FlownLevel terrain_level(const std::string& terrain, double tau_px, const FlownDisplay& display);

/// Options of `tedavis shot` that draw a level, each after a space, without pose and output; nothing where a level is more than
/// such options.
[[nodiscard]] std::optional<std::string> shot_options(const FlownLevel& level);

class FlownPictures {
public:
    /// Throws UserError where a display cannot be started.
    FlownPictures(const std::vector<FlownLevel>& levels, std::vector<AircraftPose> poses);
    ~FlownPictures();
    FlownPictures(const FlownPictures&) = delete;
    FlownPictures& operator=(const FlownPictures&) = delete;

    [[nodiscard]] const std::vector<AircraftPose>& poses() const { return poses_; }
    /// Brings a level's display to a pose and draws there once, so that a further frame has nothing left to load.
    void show(std::size_t level, std::size_t pose);
    /// Plans a further frame there, draws it and reads it back; calls show() before, where that has not just been done.
    void draw(std::size_t level, std::size_t pose);
    /// Plans, draws and reads back a frame at another pose, which follows from the last one of the level, as in flight.
    void fly_to(std::size_t level, const AircraftPose& pose);
    /// The picture of a level at a pose, valid until the level draws again.
    [[nodiscard]] RgbaView picture(std::size_t level, std::size_t pose);
    /// The display of a level at a pose, for queries of its planner.
    [[nodiscard]] display::Display& display(std::size_t level, std::size_t pose);
    [[nodiscard]] double build_ms(std::size_t level) const;
    /// Bytes of the last frame of draw().
    [[nodiscard]] std::uint64_t uploaded_bytes(std::size_t level) const;
    /// `tedavis shot` with the options of a level at a pose; nothing where options cannot state the whole level.
    [[nodiscard]] std::optional<std::string> shot_command(std::size_t level, std::size_t pose) const;

private:
    struct Shown;
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    [[nodiscard]] static std::unique_ptr<Shown> started(const FlownLevel& level, GlChoice gl);
    void make_current(std::size_t level);
    void rest();

    std::vector<AircraftPose> poses_;
    std::vector<std::unique_ptr<Shown>> shown_;
    std::size_t current_ = kNone;  ///< the level whose surface is current
};

}  // namespace tedavis::host_sim
