#include "host_sim/sweep/draw_sweep.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/evaluation_files.hpp"
#include "host_sim/evaluation/picture_meter.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/replay/drawn_layers.hpp"
#include "host_sim/replay/posed_frame.hpp"
#include "host_sim/sweep/swept_ground.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/check.hpp"
#include "render_core/base/units.hpp"
#include "render_core/policy/flag_table.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kSmallWidth = 240;  // of a picture in the report's table

bool has_ground(const terrain::HeightAnswer& ground) {
    return ground.status == terrain::HeightStatus::land || ground.status == terrain::HeightStatus::sea;
}

/// Why nothing can be seen from there; empty where something can.
std::string reason_against(const Viewpoint& viewpoint, SweptGround& ground) {
    const terrain::HeightAnswer below = ground.at(viewpoint.position.latitude_rad, viewpoint.position.longitude_rad);
    if (below.status == terrain::HeightStatus::outside) return "outside the terrain";
    if (!has_ground(below)) return "no ground height is known below";
    return viewpoint.pose.altitude_msl_m < below.height.m + kMinClearance_m ? "below the ground" : "";
}

bool is_recovery_picture(const display::FrameRecord& record) {
    const auto is_it = [](const display::Name& flag) { return flag.view() == name_of(policy::RecordFlag::attitude_unusual); };
    return std::any_of(record.flags.begin(), record.flags.end(), is_it);
}

void place_sweep(const SweepJob& job, SweptGround& ground, Sweep& sweep) {
    sweep.place = ground.middle();
    if (job.place) {
        sweep.place.latitude_rad = base::radians(job.place->latitude_deg);
        sweep.place.longitude_rad = earth::wrap_longitude(base::radians(job.place->longitude_deg));
    }
    const terrain::HeightAnswer below = ground.at(sweep.place.latitude_rad, sweep.place.longitude_rad);
    const bool has_altitude = job.place && job.place->altitude_msl_m;
    if (!has_altitude && !has_ground(below))
        throw UserError("--around: no ground height is known there in " + job.terrain_name +
                        "; name a place on it ('tedavis terrain info' says what it covers), or its altitude as a third number");
    sweep.place_msl_m = has_altitude ? *job.place->altitude_msl_m : below.height.m;
    sweep.place.height = earth::to_ellipsoid({sweep.place_msl_m}, below.undulation);
}

std::vector<Viewpoint> viewpoints_of(const Sweep& sweep, SweptGround& ground) {
    const auto geoid = [&](double latitude_rad, double longitude_rad) {
        return ground.at(latitude_rad, longitude_rad).undulation;
    };
    std::vector<Viewpoint> viewpoints = viewpoints_round(sweep.place, geoid, sweep.rings);
    std::set<std::string> names;
    for (const Viewpoint& viewpoint : viewpoints)
        if (!names.insert(viewpoint.name).second)
            throw UserError("--distances, --heights: two of them are the same to a metre (" + viewpoint.name +
                            "); leave one out");
    return viewpoints;
}

/// One display, one meter, and what they look at.
class SweepDrawer {
public:
    SweepDrawer(const SweepJob& job, WrittenFiles& files, DisplaySession& session, SweptGround& ground)
        : job_(job), files_(files), session_(session), ground_(ground), meter_(EvaluationSettings()) {}

    /// Nothing from where the display shows its recovery picture.
    [[nodiscard]] std::optional<SweptView> draw(const Viewpoint& viewpoint, const Sweep& sweep) {
        AircraftPose pose = viewpoint.pose;
        pose.time = job_.time;
        const FrameResult frame = posed_frame(session_, pose, job_.phase);
        if (is_recovery_picture(frame.record)) return std::nullopt;
        SweptView view;
        view.viewpoint = viewpoint;
        view.file = viewpoint.name + ".png";
        view.hash = frame.hash;
        const RgbaPicture picture = upright(session_.pixels());
        write(view.file, picture);
        const LayerMask mask = layers_of(view.file);
        view.measures = meter_.measure(picture, view.file, &mask, {});
        view.small_png = encode_small_png(view_of(shrunk(view_of(picture), kSmallWidth)));
        judge_place(sweep, view);
        return view;
    }
    /// All views of it, as of an evaluated picture.
    [[nodiscard]] StandingOut stand_out(const std::string& title, std::size_t index, const SweptView& view) {
        const RgbaPicture picture = read_png(job_.folder + "/" + view.file);
        PictureMeasures measures = meter_.measure(picture, view.file, nullptr, {});
        const MeasuredOpinions opinions = clutter_opinions(picture);
        measures.opinions = opinions.numbers;
        const PictureViews views = picture_views(picture, meter_, measures, opinions.congestion, EvaluationSettings());
        const std::string path = job_.folder + "/" + view.viewpoint.name;
        for (const std::string& file : all_view_files(path)) files_.add(file);
        write_views(job_.folder, view.viewpoint.name, view.viewpoint.name + ": " + title, picture, views, measures);
        MomentViews small = small_views(picture, views);
        return {title, index, opinions.numbers, std::move(small.picture), std::move(small.heat), std::move(small.edges)};
    }

private:
    void write(const std::string& file, const RgbaPicture& picture) {
        files_.add(job_.folder + "/" + file);
        write_png(job_.folder + "/" + file, view_of(picture));
    }
    [[nodiscard]] LayerMask layers_of(const std::string& file) {
        LayerMask mask{session_.width(), session_.height(), drawn_layers(session_), {}};
        for (const std::string_view name : display::kPictureLayerNames) mask.names.emplace_back(name);
        if (!job_.layers) return mask;
        files_.add(layer_mask_path(job_.folder + "/" + file));
        write_layer_mask(job_.folder + "/" + file, {mask.layers.data(), mask.width, mask.height});
        return mask;
    }
    void judge_place(const Sweep& sweep, SweptView& view) {
        view.place =
            place_in_picture(session_.display().planned().picture.camera.view, earth::to_ecef(sweep.place), job_.radius_m);
        if (!view.place.is_inside) {
            view.sight = PlaceSight::outside_picture;
            return;
        }
        view.sight = ground_.hides(sweep.place, view.viewpoint.position) ? PlaceSight::behind_terrain : PlaceSight::seen;
        session_.draw_up_to(display::PictureLayer::labels);
        static_cast<void>(meter_.measure(upright(session_.pixels()), view.file, nullptr, {}));
        view.saliency = place_saliency(meter_.saliency(), view.place);
    }

    const SweepJob& job_;
    WrittenFiles& files_;
    DisplaySession& session_;
    SweptGround& ground_;
    PictureMeter meter_;
};

void draw_views(SweepDrawer& drawer, const std::vector<Viewpoint>& viewpoints, SweptGround& ground, const SweepJob& job,
                Console& console, Sweep& sweep) {
    for (std::size_t n = 0; n < viewpoints.size(); ++n) {
        sweep.interrupted = job.is_stopped();
        if (sweep.interrupted) break;
        std::string reason = reason_against(viewpoints[n], ground);
        if (reason.empty()) {
            if (std::optional<SweptView> view = drawer.draw(viewpoints[n], sweep))
                sweep.views.push_back(std::move(*view));
            else
                reason = "so steep that the display shows its recovery picture";
        }
        if (!reason.empty()) sweep.skipped.push_back({viewpoints[n], reason});
        console.progress("viewpoints", n + 1, viewpoints.size());
    }
    console.progress_done();
}

/// What is said of views; of one view all at once.
void add_standing_out(SweepDrawer& drawer, Sweep& sweep) {
    std::map<std::size_t, std::string> words;
    const auto say = [&](std::size_t index, const char* what) {
        words[index] += (words[index].empty() ? "" : ", ") + std::string(what);
    };
    say(most_cluttered(sweep.views), "most clutter");
    say(least_cluttered(sweep.views), "least clutter");
    if (const auto strongest = strongest_place(sweep.views)) say(*strongest, "the place draws the eye most");
    for (const auto& [index, title] : words) sweep.standing_out.push_back(drawer.stand_out(title, index, sweep.views[index]));
}

void require_some_view(const SweepJob& job, const Sweep& sweep) {
    if (!sweep.views.empty()) return;
    if (sweep.interrupted) throw Interrupted("interrupted; nothing was written");
    throw UserError("--around: none of " + std::to_string(sweep.skipped.size()) + " viewpoints can be drawn over " +
                    job.terrain_name + " (the first: " + sweep.skipped.front().reason +
                    "); name another place, or other --distances or --heights");
}

}  // namespace

Sweep draw_sweep(const SweepJob& job, WrittenFiles& files, Console& console, std::string& fault) {
    DisplaySession session(job.picture, false);
    TEDAVIS_CHECK(session.display().planner().terrain_database() != nullptr);
    SweptGround ground(*session.display().planner().terrain_database());
    Sweep sweep;
    sweep.terrain = job.terrain_name;
    sweep.scene = job.scene_name;
    sweep.design = job.picture.design;
    sweep.device = job.picture.device;
    sweep.gl = session.gl_description();
    sweep.radius_m = job.radius_m;
    sweep.rings = job.rings;
    place_sweep(job, ground, sweep);
    SweepDrawer drawer(job, files, session, ground);
    draw_views(drawer, viewpoints_of(sweep, ground), ground, job, console, sweep);
    require_some_view(job, sweep);
    add_standing_out(drawer, sweep);
    fault = session.terrain_fault();
    return sweep;
}

}  // namespace tedavis::host_sim
