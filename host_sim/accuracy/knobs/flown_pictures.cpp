#include "host_sim/accuracy/knobs/flown_pictures.hpp"

#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/display/preroll.hpp"

namespace tedavis::host_sim {

std::string changed_device(const std::string& folder, const std::string& name, const std::string& shipped,
                           const std::vector<DeviceValue>& values) {
    const std::string origin = resolve_config(shipped, "devices");
    std::string text = read_file(origin);
    for (const DeviceValue& value : values) {
        const std::string key = "\n" + value.key + " = ";
        const std::size_t after = text.find(value.after), at = after == std::string::npos ? after : text.find(key, after);
        if (at == std::string::npos) throw UserError(origin + ": has no '" + value.key + "'; restore the shipped file");
        const std::size_t begin = at + key.size();
        text.replace(begin, text.find('\n', begin) - begin, value.value);
    }
    std::string path = folder + "/" + name + ".toml";
    write_file_atomically(path, text);
    return path;
}

std::optional<std::string> shot_options(const FlownLevel& level) {
    const PictureOptions& picture = level.picture;
    if (level.change || level.quality || level.has_own_device || !picture.scene.empty() || !picture.size) return std::nullopt;
    const std::string options = " --terrain " + picture.terrain + " --design " + picture.design + " --device " + picture.device +
                                " --size " + size_word(*picture.size);
    return picture.tau_px ? options + printed(" --tau %g", *picture.tau_px) : options;
}

FlownLevel flown_level(const std::string& terrain, const FlownDisplay& display) {
    FlownLevel level;
    level.picture.terrain = terrain;
    level.picture.size = display.size;
    level.picture.device = display.device;
    level.picture.design = display.design;
    return level;
}

FlownLevel terrain_level(const std::string& terrain, double tau_px, const FlownDisplay& display) {
    FlownLevel level = flown_level(terrain, display);
    level.picture.tau_px = tau_px;
    return level;
}

/// A level's display, and what it knew at its start.
struct FlownPictures::Shown {
    DisplaySession session;
    std::unique_ptr<display::PlannerMemory> begun;
    double build_ms = 0;
    std::size_t pose = kNone;  ///< that is shown
    std::optional<std::string> shot_options;
    std::uint64_t uploaded_bytes = 0;
    flight::AircraftState state;
    std::function<void(const AircraftPose&, flight::AircraftState&)> complete;  ///< of the level

    explicit Shown(const PictureOptions& options) : session(options, true) {}

    void take_state(const AircraftPose& at) {
        state = posed_aircraft(at, session.display());
        if (complete) complete(at, state);
    }
};

FlownPictures::FlownPictures(const std::vector<FlownLevel>& levels, std::vector<AircraftPose> poses) : poses_(std::move(poses)) {
    const GlChoice gl = offered_gl();
    for (const FlownLevel& level : levels) {
        shown_.push_back(started(level, gl));
        shown_.back()->session.rest();
    }
}

std::unique_ptr<FlownPictures::Shown> FlownPictures::started(const FlownLevel& level, GlChoice gl) {
    PictureOptions options = level.picture;
    options.gl = gl;
    const base::Time begun = platform::monotonic_now();
    auto shown = std::make_unique<Shown>(options);
    shown->shot_options = shot_options(level);
    shown->complete = level.complete;
    display::Display& display = shown->session.display();
    if (level.change) {
        const auto design = std::make_unique<design::DesignSettings>(load_design(options));
        level.change(*design);
        if (!display.set_design(*design)) throw UserError(options.design + ": lacks what a level of the knob needs");
    }
    shown->build_ms = (platform::monotonic_now() - begun).to_seconds() * 1000;
    shown->begun = std::make_unique<display::PlannerMemory>(display.memory());
    if (level.quality) shown->begun->budget.pin(*level.quality);
    return shown;
}

FlownPictures::~FlownPictures() { rest(); }

void FlownPictures::rest() {
    if (current_ != kNone) shown_[current_]->session.rest();
    current_ = kNone;
}

double FlownPictures::build_ms(std::size_t level) const { return shown_[level]->build_ms; }

std::uint64_t FlownPictures::uploaded_bytes(std::size_t level) const { return shown_[level]->uploaded_bytes; }

std::optional<std::string> FlownPictures::shot_command(std::size_t level, std::size_t pose) const {
    const std::optional<std::string>& options = shown_[level]->shot_options;
    if (!options) return std::nullopt;
    return "tedavis shot" + *options + " --pose " + pose_text(poses_[pose]) + phase_option(poses_[pose]) + " -o picture.png";
}

void FlownPictures::make_current(std::size_t level) {
    if (current_ == level) return;
    rest();
    shown_[level]->session.make_current();
    current_ = level;
}

void FlownPictures::show(std::size_t level, std::size_t pose) {
    make_current(level);
    Shown& shown = *shown_[level];
    display::Display& display = shown.session.display();
    display.memory() = *shown.begun;
    shown.take_state(poses_[pose]);
    const flight::FrameInput input = {shown.state, phase_of(poses_[pose]), poses_[pose].time};
    display::settle(display, input);
    display.plan(input);
    shown.session.draw();
    shown.pose = pose;
}

void FlownPictures::draw(std::size_t level, std::size_t pose) {
    if (current_ != level || shown_[level]->pose != pose) show(level, pose);
    Shown& shown = *shown_[level];
    shown.session.display().plan({shown.state, phase_of(poses_[pose]), poses_[pose].time});
    shown.session.draw();
    shown.uploaded_bytes = shown.session.display().gl().frame().uploaded_bytes;
    rest();
}

void FlownPictures::fly_to(std::size_t level, const AircraftPose& pose) {
    make_current(level);
    Shown& shown = *shown_[level];
    shown.pose = kNone;
    shown.take_state(pose);
    shown.session.display().plan({shown.state, phase_of(pose), pose.time});
    shown.session.draw();
}

RgbaView FlownPictures::picture(std::size_t level, std::size_t pose) {
    if (shown_[level]->pose != pose) show(level, pose);
    rest();
    return shown_[level]->session.pixels();
}

display::Display& FlownPictures::display(std::size_t level, std::size_t pose) {
    static_cast<void>(picture(level, pose));
    return shown_[level]->session.display();
}

}  // namespace tedavis::host_sim
